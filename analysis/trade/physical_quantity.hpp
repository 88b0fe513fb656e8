// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/unit.hpp"

namespace shortfall {

/// A number with the unit that was written behind it, in SI units (angles in radians).
struct PhysicalQuantity {
  Rational value;  ///< exact; degrees by pi to 60 digits
  /// None for a bare number, which counts in the scene's own units.
  std::optional<PhysicalDimension> dimension;
};

/// "9.81 m/s^2", "1.7 m", "60 Hz", "0.4 kg", "3 km/h", "12", "1/3 N/kg".
///
/// throws  BadInput  a sentence about the number or the unit, with a suggestion
PhysicalQuantity physical_quantity(std::string_view text);

/// The names of a scene's units of length, time and mass, and how large each is in SI units.
struct UnitSystem {
  std::string length = "m";
  std::string time = "s";
  std::string mass = "kg";
  Rational metres = 1;
  Rational seconds = 1;
  Rational kilograms = 1;

  /// throws  BadInput  for a word that is no unit of that dimension
  static UnitSystem of(const std::string& length, const std::string& time, const std::string& mass);
  /// What an SI value is worth in these units.
  Rational from_si(const Rational& value, const PhysicalDimension& dimension) const;
  /// "m", "m/s", "1/s^2", "" for a pure number.
  std::string unit(const PhysicalDimension& dimension) const;
};

}  // namespace shortfall
