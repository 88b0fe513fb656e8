// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <string>
#include <vector>

#include "analysis/floating/exact_state.hpp"
#include "analysis/floating/exact_step.hpp"
#include "analysis/floating/exact_trajectory.hpp"

namespace shortfall {

/// What a trajectory consists of. It stays where it is: the state refers to the step.
struct ExactTrajectory::Parts {
  Parts(const StepMatrix& matrix, const Rational& length)
      : step(exact_step(matrix)), state(step), h(length), assumed(matrix.map.assumed) {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  const ExactStep::Report& report(bool velocity) const { return velocity ? step.velocity : step.position; }
  /// The numerator; where it is no entry of the state itself, it is put into `room`.
  const mpz_class& numerator(bool velocity, mpz_class& room);
  /// Of the numerator: R D0 D^n.
  mpz_class denominator(bool velocity);

  ExactStep step;
  ExactState state;
  Rational h;
  std::vector<std::string> assumed;

 private:
  std::int64_t power_of_ = 0;  ///< the n of `power_`
  mpz_class power_ = 1;        ///< D^n, carried on from the last frame where somebody needed it
};

}  // namespace shortfall
