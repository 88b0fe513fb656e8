// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/unit.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace shortfall {

namespace {

constexpr std::string_view kPi = "3.14159265358979323846264338327950288419716939937510582097494";

const std::vector<PhysicalUnit>& units() {
  static const std::vector<PhysicalUnit> all{
      {"um", Rational(1, 1'000'000), kPhysicalLength},
      {"mm", Rational(1, 1000), kPhysicalLength},
      {"cm", Rational(1, 100), kPhysicalLength},
      {"m", 1, kPhysicalLength},
      {"km", 1000, kPhysicalLength},
      {"px", 1, kPhysicalLength},
      {"au", Rational(149'597'870'700), kPhysicalLength},  // IAU (2012), resolution B2
      {"ns", Rational(1, 1'000'000'000), kPhysicalTime},
      {"us", Rational(1, 1'000'000), kPhysicalTime},
      {"ms", Rational(1, 1000), kPhysicalTime},
      {"s", 1, kPhysicalTime},
      {"min", 60, kPhysicalTime},
      {"h", 3600, kPhysicalTime},
      {"day", 86400, kPhysicalTime},
      {"year", 31'557'600, kPhysicalTime},  // of 365.25 days
      {"Hz", 1, kPhysicalRate},
      {"fps", 1, kPhysicalRate},
      {"g", Rational(1, 1000), kPhysicalMass},
      {"kg", 1, kPhysicalMass},
      {"t", 1000, kPhysicalMass},
      {"N", 1, {1, -2, 1}},
      {"J", 1, {2, -2, 1}},
      {"rad", 1, {}},
      {"deg", Rational::parse(kPi) / Rational(180), {}},
      {"%", Rational(1, 100), {}}};
  return all;
}

}  // namespace

std::string PhysicalDimension::str() const {
  std::string text;
  for (const auto& [letter, exponent] :
       std::array<std::pair<const char*, int>, 3>{{{"L", length}, {"T", time}, {"M", mass}}})
    if (exponent != 0)
      text += (text.empty() ? "" : " ") + std::string(letter) +
              (exponent == 1 ? "" : "^" + std::to_string(exponent));
  return text.empty() ? "1" : text;
}

const PhysicalUnit* find_unit(std::string_view name) {
  const auto found = std::ranges::find(units(), name, &PhysicalUnit::name);
  return found == units().end() ? nullptr : &*found;
}

std::vector<std::string> unit_names(const PhysicalDimension& dimension) {
  std::vector<std::string> names;
  for (const PhysicalUnit& unit : units())
    if (unit.dimension == dimension) names.emplace_back(unit.name);
  return names;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const PhysicalUnit& unit : units()) names.emplace_back(unit.name);
  return names;
}

}  // namespace shortfall
