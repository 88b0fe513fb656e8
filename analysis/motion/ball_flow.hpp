// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/ball.hpp"

namespace shortfall {

/// The true motion under -k x - c v after a time t, from x0 = 1, v0 = 0 (cosine) and from x0 = 0, v0 = 1
/// (sine), with the velocities (rates). The four numbers are the matrix exp(t A) of the motion.
struct BallFlow {
  Ball cosine, sine, cosine_rate, sine_rate;
};

/// Oscillating, overdamped, critically damped, without a spring, without anything: told apart exactly, since
/// k and c are exact. For k < 0 the motion runs away, and the formulas (with cosh and sinh) say so.
///
/// param   bits  the working precision; a motion of many periods needs as many more as the period count has
BallFlow ball_flow(const Rational& k, const Rational& c, const Rational& t, int bits);

/// The same for numbers that are not rational, such as the damping -log(1 - c). Where the balls do not tell
/// the cases apart the result is not finite: more bits will, unless the damping is exactly critical.
BallFlow ball_flow(const Ball& k, const Ball& c, const Ball& t);

}  // namespace shortfall
