// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/ball_flow.hpp"

namespace shortfall {

BallFlow ball_flow(const Rational& k, const Rational& c, const Rational& t, int bits) {
  const auto ball = [&](const Rational& value) { return Ball(value, bits); };
  const Ball zero = ball(0), one = ball(1);
  if (k.is_zero()) {
    // Apart from the rest: cosh - sinh would cancel to nothing.
    if (c.is_zero()) return {one, ball(t), zero, one};
    const Ball decay = exp(ball(-c * t));
    return {one, (one - decay) / ball(c), zero, decay};
  }
  const Rational discriminant = k - c * c / 4;
  Ball cosine = one, sine = ball(t);  // over the decay; critical damping as they stand
  if (!discriminant.is_zero()) {
    const Ball w = sqrt(ball(discriminant.abs()));
    const Ball angle = w * ball(t);
    cosine = discriminant.sign() > 0 ? cos(angle) : cosh(angle);
    sine = (discriminant.sign() > 0 ? sin(angle) : sinh(angle)) / w;
  }
  const Ball half = ball(c / 2);
  if (!c.is_zero()) {
    const Ball decay = exp(ball(-c * t / 2));
    cosine *= decay;
    sine *= decay;
  }
  return {cosine + half * sine, sine, ball(-k) * sine, cosine - half * sine};
}

BallFlow ball_flow(const Ball& k, const Ball& c, const Ball& t) {
  const Ball zero(0, t.bits()), one(1, t.bits()), half = c / Ball(2, t.bits());
  if (k.is_zero() && c.is_zero()) return {one, t, zero, one};
  if (k.is_zero()) {
    const Ball decay = exp(-c * t);
    return {one, (one - decay) / c, zero, decay};
  }
  const Ball discriminant = k - half * half;
  const bool oscillates = discriminant.sign() != -1;  // of an unknown sign: the root is not finite
  const Ball w = sqrt(oscillates ? discriminant : -discriminant), angle = w * t, decay = exp(-half * t);
  const Ball cosine = decay * (oscillates ? cos(angle) : cosh(angle));
  const Ball sine = decay * (oscillates ? sin(angle) : sinh(angle)) / w;
  return {cosine + half * sine, sine, -k * sine, cosine - half * sine};
}

}  // namespace shortfall
