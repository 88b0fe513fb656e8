// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/physical_quantity.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <utility>
#include <vector>

#include "analysis/algebra/comma_list.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

const PhysicalUnit& unit_named(std::string_view name) {
  if (const PhysicalUnit* unit = find_unit(name)) return *unit;
  const std::vector<std::string> names = unit_names();
  throw BadInput("unknown unit '" + std::string(name.substr(0, 30)) + "'" + did_you_mean(name, names) +
                 " (the units are " + comma_list(names) +
                 "; and products and quotients of them such as m/s^2)");
}

/// The scale in SI units and the dimension of a product of units.
struct UnitProduct {
  Rational scale = 1;
  PhysicalDimension dimension;
};

/// "m/s^2", "kg m^2/s^3", "1/m", "km/h".
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  UnitProduct read() {
    UnitProduct result;
    bool divide = false;
    bool first = true;
    for (skip(); next_ < text_.size(); skip()) {
      const char sign = text_[next_];
      if (sign == '/' || sign == '*' || sign == '.') {
        if (first && sign != '/') throw complain();
        divide = sign == '/';
        ++next_;
        skip();
      } else if (divide && !first) {
        divide = false;  // a new factor after a blank multiplies
      }
      const auto [scale, dimension] = factor();
      const Rational s = divide ? Rational(1) / scale : scale;
      result.scale *= s;
      result.dimension = result.dimension * dimension.pow(divide ? -1 : 1);
      first = false;
    }
    return result;
  }

 private:
  BadInput complain() const {
    return BadInput("'" + std::string(text_.substr(0, 40)) + "' is no unit; write it like m/s^2 or kg/m");
  }
  void skip() {
    while (next_ < text_.size() && text_[next_] == ' ') ++next_;
  }
  UnitProduct factor() {
    if (next_ < text_.size() && text_[next_] == '1') {  // as in 1/m
      ++next_;
      return {};
    }
    const std::size_t begin = next_;
    while (next_ < text_.size() &&
           (std::isalpha(static_cast<unsigned char>(text_[next_])) || text_[next_] == '%'))
      ++next_;
    if (next_ == begin) throw complain();
    const PhysicalUnit& unit = unit_named(text_.substr(begin, next_ - begin));
    int exponent = 1;
    if (next_ < text_.size() && text_[next_] == '^') {
      ++next_;
      const bool negative = next_ < text_.size() && text_[next_] == '-';
      if (negative) ++next_;
      if (next_ >= text_.size() || text_[next_] < '1' || text_[next_] > '6') throw complain();
      exponent = (negative ? -1 : 1) * (text_[next_] - '0');
      ++next_;
      if (next_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[next_]))) throw complain();
    }
    return {unit.scale.pow(exponent), unit.dimension.pow(exponent)};
  }

  std::string_view text_;
  std::size_t next_ = 0;
};

/// Where the number at the beginning of a text ends: digits, point, exponent, a fraction.
std::size_t number_end(std::string_view text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t begin = i;
    while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i]))) ++i;
    return i > begin;
  };
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    digits();
  }
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    const std::size_t kept = i++;
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    if (!digits()) i = kept;
  }
  if (i + 1 < text.size() && text[i] == '/' && std::isdigit(static_cast<unsigned char>(text[i + 1]))) {
    ++i;
    digits();
    if (i < text.size() && text[i] == '.') {
      ++i;
      digits();
    }
  }
  return i;
}

}  // namespace

PhysicalQuantity physical_quantity(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const std::size_t end = number_end(text);
  if (end == 0) throw BadInput("'" + std::string(text.substr(0, 40)) + "' is not a number with a unit");
  PhysicalQuantity result{Rational::parse(text.substr(0, end)), std::nullopt};
  const std::string_view unit = text.substr(end);
  if (unit.find_first_not_of(' ') == std::string_view::npos) return result;
  const UnitProduct read = UnitReader(unit).read();
  result.value *= read.scale;
  result.dimension = read.dimension;
  return result;
}

UnitSystem UnitSystem::of(const std::string& length, const std::string& time, const std::string& mass) {
  UnitSystem system{length, time, mass};
  const auto scale = [](const std::string& name, PhysicalDimension wanted, const char* what) {
    const PhysicalUnit& unit = unit_named(name);
    if (unit.dimension != wanted) throw BadInput("'" + name + "' is no unit of " + what);
    return unit.scale;
  };
  system.metres = scale(length, {1, 0, 0}, "length");
  system.seconds = scale(time, {0, 1, 0}, "time");
  system.kilograms = scale(mass, {0, 0, 1}, "mass");
  return system;
}

Rational UnitSystem::from_si(const Rational& value, const PhysicalDimension& d) const {
  return value / (metres.pow(d.length) * seconds.pow(d.time) * kilograms.pow(d.mass));
}

std::string UnitSystem::unit(const PhysicalDimension& d) const {
  std::string above, below;
  int factors_below = 0;
  for (const auto& [name, exponent] : std::array<std::pair<std::string_view, int>, 3>{
           {{length, d.length}, {mass, d.mass}, {time, d.time}}}) {
    if (exponent == 0) continue;
    std::string& side = exponent < 0 ? below : above;
    if (exponent < 0) ++factors_below;
    side += (side.empty() ? "" : " ") + std::string(name);
    if (std::abs(exponent) != 1) side += "^" + std::to_string(std::abs(exponent));
  }
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (factors_below == 1 ? below : "(" + below + ")");
}

}  // namespace shortfall
