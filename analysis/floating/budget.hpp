// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/floating/float_run.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

/// One part of an error, signed: exact minus computed. A ball that is exact, or much narrower than what it is
/// a part of.
struct BudgetTerm {
  std::string name;  ///< "method", "representation", "rounding", "sampling"
  Ball value;
};

/// The error of one quantity and its parts.
struct BudgetLine {
  std::string quantity;  ///< "x", "v", "energy", "peak"
  std::string unit;      ///< "m"
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
/// on the stored constants) and, for a peak, sampling (the exact motion at the frame against its highest
/// point).
struct Budget {
  FloatFormat format;
  FloatQuestion question;
  FloatQuestion stored;
  std::int64_t steps = 0;
  std::vector<BudgetLine> lines{};
  /// How many steps were compared with the exact map of the stored constants, and the first one after which
  /// the run is not that; none when all that were compared are. Irrational coefficients: 0 are compared.
  std::int64_t compared = 0;
  std::optional<std::int64_t> differs_at{};
  /// Rounding is at most this in x, in m: a bound from one step's roundings and the powers of its matrix,
  /// with the largest x and v of the run. None for implicit steps, and formats without one rounding an
  /// operation.
  std::optional<double> rounding_bound{};
  /// The frame at which the run stopped being finite; then there are no lines.
  std::optional<std::int64_t> not_finite_at{};
};

/// The budget of x, v (and the energy where the force has one) after so many steps.
///
/// throws  BadInput  for a letter without a number, or a number of steps that cannot be run
///         Unable  when the step is not linear
Budget budget(const FloatFormat& format, const FloatQuestion& question, std::int64_t steps,
              const Progress& progress = {});

/// The budget of a jump's peak: launched upwards from the ground so that the exact parabola reaches `height`
/// under the gravity g (positive), the highest frame of the run against that height. The question's force, x0
/// and v0 are not looked at.
Budget peak_budget(const FloatFormat& format, const FloatQuestion& question, const Rational& height,
                   const Rational& g, const Progress& progress = {});

/// So many steps can be run; more would take longer than anybody waits.
inline constexpr std::int64_t kMostFloatSteps = 2'000'000'000;

}  // namespace shortfall
