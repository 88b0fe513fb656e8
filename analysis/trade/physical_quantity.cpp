// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/physical_quantity.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <map>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

struct UnitEntry {
  Rational scale;
  PhysicalDimension dimension;
};

const Rational& pi() {
  static const Rational value =
      Rational::parse("3.14159265358979323846264338327950288419716939937510582097494");
  return value;
}

const std::map<std::string, UnitEntry, std::less<>>& units() {
  static const std::map<std::string, UnitEntry, std::less<>> table = [] {
    std::map<std::string, UnitEntry, std::less<>> t;
    const PhysicalDimension length{1, 0, 0}, time{0, 1, 0}, mass{0, 0, 1}, none{};
    const auto add = [&](const char* name, Rational scale, PhysicalDimension d) {
      t.emplace(name, UnitEntry{std::move(scale), d});
    };
    add("m", 1, length);
    add("um", Rational(1, 1'000'000), length);
    add("mm", Rational(1, 1000), length);
    add("cm", Rational(1, 100), length);
    add("km", 1000, length);
    add("px", 1, length);
    add("au", Rational(149'597'870'700), length);  // IAU (2012), resolution B2
    add("s", 1, time);
    add("ns", Rational(1, 1'000'000'000), time);
    add("us", Rational(1, 1'000'000), time);
    add("ms", Rational(1, 1000), time);
    add("min", 60, time);
    add("h", 3600, time);
    add("day", 86400, time);
    add("year", 31'557'600, time);  // of 365.25 days
    add("Hz", 1, time.pow(-1));
    add("g", Rational(1, 1000), mass);
    add("kg", 1, mass);
    add("t", 1000, mass);
    add("N", 1, PhysicalDimension{1, -2, 1});
    add("J", 1, PhysicalDimension{2, -2, 1});
    add("rad", 1, none);
    add("deg", pi() / Rational(180), none);
    add("%", Rational(1, 100), none);
    return t;
  }();
  return table;
}

const UnitEntry& unit_named(std::string_view name) {
  const auto found = units().find(name);
  if (found != units().end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [n, entry] : units()) names.push_back(n);
  std::string known;
  for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
  throw BadInput("unknown unit '" + std::string(name.substr(0, 30)) + "'" + did_you_mean(name, names) +
                 " (the units are " + known + "; and products and quotients of them such as m/s^2)");
}

/// "m/s^2", "kg m^2/s^3", "1/m", "km/h".
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  UnitEntry read() {
    UnitEntry result{1, {}};
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
  UnitEntry factor() {
    if (next_ < text_.size() && text_[next_] == '1') {  // as in 1/m
      ++next_;
      return {1, {}};
    }
    const std::size_t begin = next_;
    while (next_ < text_.size() &&
           (std::isalpha(static_cast<unsigned char>(text_[next_])) || text_[next_] == '%'))
      ++next_;
    if (next_ == begin) throw complain();
    const UnitEntry& unit = unit_named(text_.substr(begin, next_ - begin));
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

std::string powers(const std::array<std::pair<std::string, int>, 3>& parts, bool quotient) {
  std::string above, below;
  for (const auto& [name, exponent] : parts) {
    if (exponent == 0) continue;
    std::string& side = quotient && exponent < 0 ? below : above;
    const int shown = quotient ? std::abs(exponent) : exponent;
    side += (side.empty() ? "" : " ") + name + (shown == 1 ? "" : "^" + std::to_string(shown));
  }
  if (!quotient) return above.empty() ? "1" : above;
  if (below.empty()) return above;
  const std::string under = below.find(' ') == std::string::npos ? below : "(" + below + ")";
  return (above.empty() ? "1" : above) + "/" + under;
}

}  // namespace

std::string PhysicalDimension::str() const {
  return powers({{{"L", length}, {"T", time}, {"M", mass}}}, false);
}

PhysicalQuantity physical_quantity(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  const std::size_t end = number_end(text);
  if (end == 0) throw BadInput("'" + std::string(text.substr(0, 40)) + "' is not a number with a unit");
  PhysicalQuantity result{Rational::parse(text.substr(0, end)), std::nullopt};
  const std::string_view unit = text.substr(end);
  if (unit.find_first_not_of(' ') == std::string_view::npos) return result;
  const UnitEntry read = UnitReader(unit).read();
  result.value *= read.scale;
  result.dimension = read.dimension;
  return result;
}

UnitSystem UnitSystem::of(const std::string& length, const std::string& time, const std::string& mass) {
  UnitSystem system{length, time, mass};
  const auto scale = [](const std::string& name, PhysicalDimension wanted, const char* what) {
    const UnitEntry& unit = unit_named(name);
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
  return powers({{{length, d.length}, {mass, d.mass}, {time, d.time}}}, true);
}

}  // namespace shortfall
