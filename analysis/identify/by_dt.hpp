// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A peak, or a landing time, that was seen at one length of a step.
struct ByDtPoint {
  Rational dt;
  Rational value;
};

/// What peaks at several frame rates say.
struct ByDt {
  double order = 0;          ///< of the error: value = limit + slope dt^order
  bool whole_order = false;  ///< the points are those of a whole order
  double limit = 0;          ///< at a step of 0
  double slope = 0;
  double misfit = 0;  ///< of the points that were not used, the largest
  /// Per maps of first order: the error of an undamped jump, in units of half a step times the launch.
  /// +1 drifts before it kicks, -1 kicks first, -1/N does so in N substeps.
  std::optional<double> share;
  std::vector<std::string> maps;  ///< that err on this side; with gravity or launch known, by this much
};

/// Three points or more.
///
/// param   g  of the same unit of length, when it is known: it says how many substeps there are
/// throws  BadInput  for fewer points, or equal steps;  Undefined  when the values do not converge
ByDt by_dt(std::vector<ByDtPoint> points, std::optional<double> g = std::nullopt);

}  // namespace shortfall
