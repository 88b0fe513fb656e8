// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/floating/binary_format.hpp"

namespace shortfall {

/// t := t + dt, each sum rounded, again and again: a clock, or a position under a constant velocity.
struct Accumulator {
  BinaryFormat format;
  Rounding rounding = Rounding::nearest_even;
  Rational start;      ///< of the format
  Rational increment;  ///< dyadic, not 0; not in the format where a product was fused into the sum
};

/// Additions in a row that all advance the value by the same amount.
struct AccumulatorRun {
  Rational before;     ///< how many additions went before
  Rational additions;  ///< 1 or more
  Rational from;       ///< the value before the first of them
  Rational increment;  ///< of the value, by each
  long unit = 0;       ///< these sums are rounded to multiples of 2^unit, or are exact
  bool exact = false;  ///< none of these sums was rounded

  Rational to() const { return from + additions * increment; }
};

/// The way of an accumulator, in closed form.
///
/// Invariant: the runs follow on each other, from 0 additions on.
struct AccumulatorPath {
  enum class End {
    frozen,       ///< from then on an addition changes nothing
    overflowed,   ///< the next addition gives infinity
    not_reached,  ///< it goes on beyond what was followed
  };
  Accumulator clock;
  std::vector<AccumulatorRun> runs;
  End end = End::frozen;

  /// How many additions all runs together are. When frozen, the number that changed the value.
  Rational additions() const;
  /// The value after them.
  Rational last() const;
  /// The value after so many additions; none when it is infinite.
  ///
  /// throws  Unable  beyond what was followed
  std::optional<Rational> after(const Rational& n) const;
  /// How many additions, from the first on, are all exact.
  Rational exact_additions() const;
};

/// Follows an accumulator to its end, or, where the end is far, at least for `least` additions.
///
/// Where the numbers of the format are multiples of one unit and the value already is one, a sum is rounded
/// by the same amount every time: the increment is constant as long as the sums stay between two powers of
/// two. To nearest even, a sum halfway between two numbers makes the first increment differ; the value is
/// then an even multiple of the unit and stays one. So a binade costs a few operations, however many
/// additions fall into it.
///
/// throws  BadInput   for an increment that is 0 or not dyadic, or a start that is no number of the format
/// throws  Unable     when `least` additions pass more than 20000 runs
AccumulatorPath accumulator_path(const Accumulator& clock, const Rational& least);

/// A stretch in which every addition adds the same.
struct Stretch {
  Rational from;       ///< value before its first addition
  Rational added;      ///< by each addition
  Rational additions;  ///< how many
};

/// Where an accumulator is after so many additions, and how it got there.
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

/// The part of a path that so many additions take.
///
/// throws  BadInput  for a number of additions that is no whole number
Accumulation part_of(const AccumulatorPath& path, const Rational& additions);
/// throws  as accumulator_path
Accumulation accumulated(const Accumulator& clock, const Rational& additions);

/// When the clock stops: the value at which another addition changes nothing. None when it becomes infinite
/// first, or goes on for too long to be followed.
std::optional<Accumulation::Freeze> freeze_of(const AccumulatorPath& path);
std::optional<Accumulation::Freeze> freezing_point(const Accumulator& clock);

}  // namespace shortfall
