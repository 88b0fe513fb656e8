// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/identify/log.hpp"

namespace shortfall {

/// The rows of a log that one map is to explain, beginning with its frame 0.
struct Observations {
  using Triple = Log::Triple;

  std::vector<int> axes;
  std::vector<std::size_t> frame;  ///< of each row, from 0
  std::vector<Triple> x, v;
  bool velocities = false;
  bool first_velocity = true;  ///< false: the velocity was set after row 0 had been written
  LogRounding rounding, velocity_rounding;
  double dt = 0;
  double most_position = 0, most_velocity = 0;  ///< the largest absolute values

  std::size_t rows() const { return x.size(); }
  std::size_t frames() const { return frame.back() + 1; }
  bool exact() const { return rounding.exact() && velocity_rounding.exact(); }
  double largest_position() const { return most_position; }
  double largest_velocity() const { return most_velocity; }
  /// Half a unit of what was written; for numbers that were not rounded, half a unit in the last place of
  /// the largest.
  double half_position(double value) const;
  double half_velocity(double value) const;
};

/// Rows first <= i < last of a log.
Observations observations(const Log& log, double dt, std::size_t first, std::size_t last);

}  // namespace shortfall
