// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <utility>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"

namespace shortfall {

/// The terms constant + slope (n - from) + gain ratio^(n - from) of a sequence, for whole n >= from.
struct GeometricSum {
  Rational constant;
  Rational slope;
  Rational gain;
};

/// A damped flight: a velocity that keeps `ratio` of itself every frame, and what sums of its powers make of
/// rise and fall.
///
/// Invariant: ratio is not 1. (Without gain it is any number but 1, and stands for nothing.)
struct GeometricFlight {
  int from = 0;
  Rational ratio;
  GeometricSum rise;
  GeometricSum fall;

  /// The value of a sum at n >= from.
  ///
  /// throws  Unable  when the number would have more than kDigits digits
  Rational at(const GeometricSum& sum, const Rational& n) const;
  static constexpr std::int64_t kDigits = 2'000'000;

  /// The first frame n >= from after which the body does not rise, when there is one because the rise of a
  /// frame, A + B ratio^(n - from), only shrinks and ends negative: 0 < ratio < 1, B > 0 > A. That the top
  /// is there and nowhere else follows; the sign at this n and the one before are decided exactly.
  std::optional<Rational> top(const Surd& launch, const Rational& g) const;
};

/// Rise and fall of a frame: height = launch * rise - g * fall.
using FrameOf = std::function<std::pair<Rational, Rational>(std::size_t)>;

/// A flight of parabolas: coefficients of 1, n, n^2, from a frame on.
struct ParabolicFlight {
  int from = 0;
  std::array<Rational, 3> rise;
  std::array<Rational, 3> fall;
};

/// The parabolas, or the damped flight, whose frames these are, if it is one.
///
/// The frames satisfy a linear recurrence of `order` from frame 1 on (Cayley and Hamilton), and what they
/// are compared with one of order 3; both agree on more frames than the two orders together, hence on all.
///
/// param   first  the frame that the step alone follows from: what a launch takes is over
std::optional<ParabolicFlight> parabolic_flight(const FrameOf& frame, int order, int first = 0);
std::optional<GeometricFlight> geometric_flight(const FrameOf& frame, int order, int first = 0);

}  // namespace shortfall
