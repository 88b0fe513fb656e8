// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/clock_arithmetic.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/float_format.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

constexpr std::array<std::pair<Rounding, const char*>, 5> kRoundings{
    {{Rounding::nearest_even, "nearest-even"},
     {Rounding::nearest_away, "nearest-away"},
     {Rounding::toward_zero, "toward-zero"},
     {Rounding::up, "up"},
     {Rounding::down, "down"}}};

constexpr int kWordBits = 63;  // and the sign

ClockArithmetic fixed_point(std::string_view name) {
  const std::string_view digits = name.substr(std::min(name.size(), std::string_view("fixed:").size()));
  int places = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), places);
  if (error != std::errc() || end != digits.data() + digits.size() || places < 0 || places > kWordBits)
    throw BadInput("the format '" + std::string(name.substr(0, 60)) +
                   "': fixed takes a number of bits after the point from 0 to 63, such as fixed:23");
  ClockArithmetic result;
  result.format_name = "fixed:" + std::to_string(places);
  result.words = "fixed point, " + std::to_string(places) + " bits after the point, in a 64-bit word";
  // Every multiple of the unit that fits is a number of this format: sums are never rounded.
  result.format = {kWordBits, -places, kWordBits - 1 - places};
  result.fixed_point = true;
  return result;
}

}  // namespace

ClockArithmetic clock_arithmetic(std::string_view name) {
  if (name.starts_with("fixed")) return fixed_point(name);
  const FloatFormat f = float_format(name);
  if (f.kind == FloatFormat::Kind::double_double)
    throw Unable(
        "a double-double is no binary format of one precision, so that its clock has no closed form here; "
        "--format mpfr:32 has as many digits");
  if (f.variant == FloatFormat::Variant::offset)
    throw Unable("a clock with a binary64 origin is as exact as its origin: ask for --format f64");
  ClockArithmetic result;
  result.format_name = f.name().substr(0, f.name().find('+'));
  FloatFormat plain = f;
  plain.variant = FloatFormat::Variant::plain;
  result.words = plain.words();
  result.format = f.storage();
  result.rounding = f.rounding();
  result.fused = f.variant == FloatFormat::Variant::fused;
  result.compensated = f.variant == FloatFormat::Variant::compensated;
  return result;
}

Rounding rounding_named(std::string_view name) {
  std::vector<std::string> names;
  for (const auto& [rounding, known] : kRoundings) {
    if (name == known) return rounding;
    names.emplace_back(known);
  }
  throw BadInput("there is no rounding '" + std::string(name.substr(0, 60)) + "'" +
                 did_you_mean(name, names) + "; there are nearest-even, nearest-away, toward-zero, up, down");
}

std::string name_of(Rounding rounding) {
  return std::ranges::find(kRoundings, rounding, &std::pair<Rounding, const char*>::first)->second;
}

}  // namespace shortfall
