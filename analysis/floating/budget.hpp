// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/floating/first_difference.hpp"
#include "analysis/floating/float_run.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

/// One part of an error, signed: exact minus computed. A ball that is exact, or much narrower than what it is
/// a part of.
struct BudgetTerm {
  std::string name;  ///< "method", "representation", "rounding", "sampling"
  Ball value;
};

/// Something that can be changed, and what a term of the first line is then.
struct BudgetRemedy {
  std::string term;
  std::string change;  ///< "dt = 1/100 s", "f32+kahan"
  Ball becomes;        ///< computed with the change, not estimated
};

/// The error of one quantity and its parts.
struct BudgetLine {
  std::string quantity;  ///< "x", "v", "energy", "peak", "landing", "period"
  std::string unit;      ///< "m", "m/s", "m^2/s^2", "s"
  FloatNumber computed;  ///< by the run
  Ball truth;
  Ball observed;  ///< truth - computed, from a run and a truth of their own; no part is a remainder
  std::vector<BudgetTerm> terms;
  Ball residual;  ///< observed minus the sum of the terms: holds 0

  /// Whether the residual holds 0 and is as narrow as it has to be.
  bool closes() const;
};

/// Where a floating-point error comes from: the method (its exact map against the exact motion), the
/// representation (the constants, stored in the format), rounding (the run against the same map, run exactly
/// on the stored constants) and, for what is read off frames (a peak, a landing, a period), sampling (the
/// exact motion seen at its frames against the exact motion).
struct Budget {
  FloatFormat format;
  FloatQuestion question;
  FloatQuestion stored;
  std::int64_t steps = 0;
  int periods = 0;  ///< over which a period is measured
  std::vector<BudgetLine> lines{};
  std::vector<BudgetRemedy> remedies{};
  /// Where the run first is not the exact map of its stored constants; irrational coefficients: 0 steps are
  /// compared.
  FirstDifference difference{};
  /// Rounding in x and v (of a peak: in x at the frame), as tracked beside the second run, rounded to
  /// binary64; none for formats that are not tracked.
  std::optional<std::pair<double, double>> tracked{};
  /// Rounding is at most this in x, in m: a bound from one step's roundings and the powers of its matrix,
  /// with the largest x and v of the run. None for implicit steps, and formats without one rounding an
  /// operation.
  std::optional<double> rounding_bound{};
  /// Why the exact map is not known, where it is not: then there are no lines, but `tracked`.
  std::string reason{};
  /// The frame at which the run stopped being finite; then there are no lines.
  std::optional<std::int64_t> not_finite_at{};
};

/// The budget of x, v (and the energy where the force has one) after so many steps.
///
/// throws  BadInput  for a letter without a number, or a number of steps that cannot be run
///         Unable  when the step is not linear and its rounding is not tracked either
Budget budget(const FloatFormat& format, const FloatQuestion& question, std::int64_t steps,
              const Progress& progress = {});

/// The budget of a jump's peak: launched upwards from the ground so that the exact parabola reaches `height`
/// under the gravity g (positive), the highest frame of the run against that height. The question's force, x0
/// and v0 are not looked at.
Budget peak_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                   const Rational& g, const Progress& progress = {});

/// The budget of the time at which such a jump is back at the ground: the first frame that is not above it,
/// and between that and the one before a straight line.
///
/// throws  Unable  where something never leaves the ground, or does not come back in three flights
Budget landing_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                      const Rational& g, const Progress& progress = {});

/// The budget of an oscillation's period: the time from the first passing through the level where the spring
/// is at rest to the one 2 * periods later, divided by their number; passings are read as landings are.
///
/// throws  Unable  for other forces than a spring with or without damping and constant push, and with less
/// than two
///                 frames a period;  Undefined  when nothing oscillates
Budget period_budget(const FloatFormat& format, const FloatQuestion& question, int periods,
                     const Progress& progress = {});
inline constexpr int kMostPeriods = 100'000;

/// So many steps can be run; more would take longer than anybody waits.
inline constexpr std::int64_t kMostFloatSteps = 2'000'000'000;

}  // namespace shortfall
