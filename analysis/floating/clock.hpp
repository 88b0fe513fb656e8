// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/floating/accumulator.hpp"
#include "analysis/floating/clock_arithmetic.hpp"
#include "analysis/floating/compensated_clock.hpp"

namespace shortfall {

/// A clock t += dt, or a uniform motion x += v dt with constant v dt, as people ask about it.
struct ClockQuestion : ClockArithmetic {
  Rational dt;  ///< that is meant, not 0
  std::optional<Rational>
      kept_dt;  ///< that is given, when it was said (0.1f for 0.1); then rounded to the format
  Rational start;
  std::optional<Rational> velocity;  ///< then it is a position, x := x + v dt
  Rational additions;
  Rational most_stepped = 1'000'000;  ///< additions that may be carried out one by one for Kahan's sum

  /// What an addition is meant to add.
  Rational advance() const { return velocity ? *velocity * dt : dt; }
};

/// How fast a clock goes where its sums share one spacing of the numbers.
struct ClockSpeed {
  Rational before;     ///< additions before
  Rational additions;  ///< inside
  Rational from, to;   ///< values before the first and after the last of them
  long unit = 0;       ///< the spacing is 2^unit
  bool exact = false;  ///< no sum is rounded
  Rational increment;  ///< of the value by each addition, but for at most two at the beginning
  Rational entering;   ///< how many they are
  Rational rate;       ///< increment over what is meant

  Rational parts_per_million() const { return (rate - Rational(1)) * Rational(1'000'000); }  ///< fast
  Rational lost_per_hour() const { return (Rational(1) - rate) * Rational(3600); }           ///< seconds
};

/// Something to use instead, after as many steps.
struct ClockAlternative {
  enum class Kind {
    divided,      ///< steps counted in an integer, divided by the rate (a whole number) when the time is read
    multiplied,   ///< steps counted in an integer, times the stored dt
    compensated,  ///< Kahan's sum
    wider,        ///< the same additions in a wider format
    dyadic,       ///< the power of two nearest to dt as the step: its additions are exact
  };
  Kind kind = Kind::multiplied;
  std::optional<Rational> value = {}, shortfall = {};       ///< none for dyadic: it is another clock
  std::optional<Rational> rate = {};                        ///< of divided
  std::optional<ClockArithmetic> arithmetic = {};           ///< of wider
  std::optional<Rational> step = {}, exact_additions = {};  ///< of dyadic: so many are exact
  std::optional<CompensatedClock> sum = {};                 ///< of compensated
};

/// Everything that can be said about a clock after n steps, exactly.
struct ClockReport {
  ClockQuestion question;
  Rational stored_dt, stored_start;
  std::optional<Rational> stored_velocity;
  Rational increment;     ///< what is added: stored, the product v dt rounded unless fused
  Rational meant;         ///< start + n dt (or n v dt)
  Rational stored_meant;  ///< the same of the stored numbers, in exact arithmetic
  AccumulatorPath path;   ///< of the plain sum, to its end
  Accumulation run;       ///< of the plain sum
  std::optional<Accumulation::Freeze> freezes;  ///< the plain sum, whenever that is
  std::optional<CompensatedClock> kahan;        ///< when the question is about it
  std::optional<Rational> value;                ///< none: infinite, or not known (`kahan` says)
  /// Exact minus computed: of the stored numbers in exact arithmetic, and of the run against that. Their sum
  /// is `shortfall`.
  Rational representation;
  std::optional<Rational> rounding_part, shortfall;
  std::vector<ClockSpeed> speeds;
  /// One multiplication n * dt instead, rounded once (and n and dt once each).
  std::optional<Rational> by_multiplication;
  std::vector<ClockAlternative> instead;
};

/// throws  BadInput  when dt, the velocity or what is added is 0, or infinite in the format; when steps are
///                   negative or no whole number
/// throws  Unable    see `accumulator_path`
ClockReport clock_report(const ClockQuestion& question, const Progress& progress = {});

}  // namespace shortfall
