// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/algebra/rational.hpp"
#include "analysis/floating/binary_format.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

/// What Kahan's compensated sum of n equal numbers is, and how that is known.
struct CompensatedClock {
  enum class Kind {
    closed_form,  ///< start + n increment, rounded once: proved
    stepped,      ///< all additions were carried out
    bounded,      ///< only how far from start + n increment it can be: proved
    unknown,      ///< neither
  };
  Kind kind = Kind::unknown;
  std::optional<Rational> value;         ///< none when infinite (stepped), or not known
  std::optional<Rational> bound;         ///< of |start + n increment - value|
  Rational closed_until;                 ///< for so many additions the closed form is proved; 0 when for none
  std::optional<Rational> frozen_after;  ///< found while stepping: from then on nothing changes
};

/// y = increment - c; t = s + y; c = (t - s) - y; s = t, n times from s = start, c = 0, every operation
/// rounded.
///
/// Closed form, to nearest: all numbers are multiples of g, the lowest bit of start and increment. As long as
/// |increment| + u/2 <= 2^p g, with u the spacing of the numbers around the largest sum, y is exact, and c is
/// what the last sum was rounded by (Fast2Sum); so every sum is rounded from start + k increment exactly.
/// Beyond that y is rounded by at most half its spacing in each step, which gives the bound.
///
/// param   start, increment  numbers of the format
/// param   most_stepped      additions that may be carried out
/// source  Kahan (1965), Further remarks on reducing truncation errors; Dekker (1971), A floating-point
/// technique for
///         extending the available precision (Fast2Sum); Higham (2002), Accuracy and Stability, section 4.3
CompensatedClock compensated_clock(const Rational& start, const Rational& increment,
                                   const BinaryFormat& format, Rounding rounding, const Rational& n,
                                   const Rational& most_stepped, const Progress& progress = {});

}  // namespace shortfall
