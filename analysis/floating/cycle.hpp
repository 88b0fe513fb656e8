// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/floating/float_run.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

/// A run in a finite set of numbers comes back to a state that it had: from then on it repeats itself, and
/// what is true of one period is true for all time.
///
/// source  Brent (1980), An improved Monte Carlo factorization algorithm, BIT 20 (constant memory)
struct Cycle {
  std::int64_t tail = 0;                        ///< steps before the first state that returns
  std::int64_t period = 0;                      ///< steps
  std::int64_t turns = 0;                       ///< oscillations in one period: how often x passes 0 upwards
  double largest_x = 0, largest_v = 0;          ///< ever, tail included
  double least_energy = 0, largest_energy = 0;  ///< v^2/2 + k x^2/2 - f0 x per mass, ever; rounded
  std::int64_t looked_at = 0;                   ///< steps that were run to find it
};

struct CycleSearch {
  std::optional<Cycle> found;
  std::optional<std::int64_t> not_finite_at;
  std::int64_t looked_at = 0;
};

/// param   most  steps before giving up; memory does not grow with it
/// throws  Unable  for a force that depends on time, and for formats that binary64 does not hold
CycleSearch cycle(const FloatFormat& format, const FloatQuestion& question, std::int64_t most,
                  const Progress& progress = {});

}  // namespace shortfall
