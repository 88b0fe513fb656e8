// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// Powers of length, time and mass; an angle is a pure number.
struct PhysicalDimension {
  int length = 0;
  int time = 0;
  int mass = 0;
  bool operator==(const PhysicalDimension&) const = default;
  PhysicalDimension operator*(const PhysicalDimension& o) const {
    return {length + o.length, time + o.time, mass + o.mass};
  }
  PhysicalDimension pow(int n) const { return {length * n, time * n, mass * n}; }
  /// "L T^-2", "1" for a pure number.
  std::string str() const;
};

inline constexpr PhysicalDimension kPhysicalLength{1, 0, 0};
inline constexpr PhysicalDimension kPhysicalTime{0, 1, 0};
inline constexpr PhysicalDimension kPhysicalRate{0, -1, 0};
inline constexpr PhysicalDimension kPhysicalMass{0, 0, 1};

/// A unit that numbers carry, in scenes, in logs and on the command line.
struct PhysicalUnit {
  std::string_view name;
  Rational scale;  ///< of one such unit in SI units (angles in radians): exact; degrees by pi to 60 digits
  PhysicalDimension dimension;
};

/// The unit of that name ("cm", "day", "Hz", "deg"), or null. A px counts as a metre: a scene in pixels has
/// no other.
const PhysicalUnit* find_unit(std::string_view name);

/// The names of all units of that dimension.
std::vector<std::string> unit_names(const PhysicalDimension& dimension);

/// The names of all units.
std::vector<std::string> unit_names();

}  // namespace shortfall
