// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/floating/binary_format.hpp"

namespace shortfall {

/// t := t + dt, each sum rounded, again and again: a clock, or a position under a constant velocity.
struct Accumulator {
  BinaryFormat format;
  Rounding rounding = Rounding::nearest_even;
  Rational start;      ///< of the format
  Rational increment;  ///< of the format, not 0
};

/// A stretch in which every addition adds the same.
struct Stretch {
  Rational from;       ///< value before its first addition
  Rational added;      ///< by each addition
  Rational additions;  ///< how many
};

/// Where an accumulator is after so many additions, and how it got there.
///
/// Inside a binade the sum grows by the same amount from the second addition on (a tie makes the first one
/// differ at most, since what a tie leaves is even), so that a binade costs a few additions, whatever their
/// number.
struct Accumulation {
  std::optional<Rational> value;  ///< none: infinite
  Rational additions;             ///< that were asked for
  /// Exactly start + n increment so far; the first addition that is not exact comes after this many.
  std::optional<Rational> exact_additions;  ///< none when all of them are
  struct Freeze {
    Rational value;
    Rational additions;  ///< after which nothing changes any more
  };
  std::optional<Freeze> freezes;  ///< when that is within the additions asked for
  std::vector<Stretch> stretches;
};

/// throws  BadInput  for an increment of 0, numbers that are none of the format, or a number of additions
/// that is no whole number
Accumulation accumulated(const Accumulator& clock, const Rational& additions);

/// When the clock stops: the value at which another addition changes nothing. None when it becomes infinite
/// first.
std::optional<Accumulation::Freeze> freezing_point(const Accumulator& clock);

/// A clock as people ask about it.
struct ClockQuestion {
  BinaryFormat format = BinaryFormat::binary32();
  std::string format_name = "f32";
  Rounding rounding = Rounding::nearest_even;
  Rational dt;                      ///< that is meant, s
  std::optional<Rational> kept_dt;  ///< that is stored, when it was said (0.1f for 0.1)
  Rational start;
  std::optional<Rational> velocity;  ///< then it is a position, x := x + v dt
  Rational additions;
};

struct ClockReport {
  ClockQuestion question;
  Rational increment;     ///< what is added, of the format
  Rational meant;         ///< start + n dt (or n v dt)
  Rational stored_meant;  ///< start + n increment
  Accumulation run;
  std::optional<Accumulation::Freeze> freezes;  ///< whenever that is
  /// One multiplication n * dt instead, rounded once (and n and dt once each).
  std::optional<Rational> by_multiplication;
  /// Compensated sums are at most so far from start + n increment.
  ///
  /// source  Higham (2002), Accuracy and Stability of Numerical Algorithms, (4.8): (2 u + O(n u^2)) n
  /// |increment|
  Rational compensated_bound;
};

/// throws  BadInput  when the increment is 0 or infinite in the format
ClockReport clock_report(const ClockQuestion& question);

}  // namespace shortfall
