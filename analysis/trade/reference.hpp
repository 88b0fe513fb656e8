// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/program/progress.hpp"
#include "analysis/trade/readings.hpp"

namespace shortfall {

/// The true motion of a scene, as far as its observables show it.
struct SceneReference {
  DoubleDouble end;  ///< until, or the true time of the event that ends the scene
  std::vector<SceneReading<DoubleDouble>> readings;
  /// Of each reading, by how much the two computations differ, in its unit: checked, not proved.
  std::vector<double> uncertain;
  int steps = 0;    ///< power series of the longer computation
  int digits = 0;   ///< that were computed with
  std::string how;  ///< "power series of order 28 and 36, two computations"
};

/// Two computations with power series of different orders, tolerances and steps, which must agree.
///
/// param   digits  decimal digits of the numbers: up to 30 they are pairs of binary64, beyond MPFR's
///         chosen  the forces that count; all when empty
///         end     when the motion is looked at, instead of its own end: to be compared with another one
/// throws  Undefined  when the motion meets a singular force;  Unable  when an observable has no true value
///         (an event never comes, a force has no energy), or the two computations differ by more than a
///         thousandth of a tolerance
SceneReference scene_reference(const Scene& scene, int digits = 30, const ForceChoice& chosen = {},
                               const Progress& progress = {}, const std::optional<DoubleDouble>& end = {});

/// The error of a reading: exact minus computed for one number (of a phase, as an angle); for a place the
/// distance from the true one, for a path the largest distance of any body; of an energy the drift itself.
double reading_error(const Scene& scene, std::size_t observable, const SceneReading<DoubleDouble>& exact,
                     const SceneReading<DoubleDouble>& computed);

}  // namespace shortfall
