// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/numeric_flow.hpp"

#include <utility>

#include "analysis/motion/ball_flow.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/motion/linear_flow.hpp"

namespace shortfall {

NumericFlow::NumericFlow(const NumericQuestion& q, const Rational& t, std::vector<ExtraLetters::Extra> extras)
    : k_(q.force.stiffness()), c_(q.force.damping()), t_(t), extras_(std::move(extras)) {
  rational_ = k_.is_constant() && c_.is_constant();
  Fraction begin, rate;
  for (int d = 0; d <= q.force.degree; ++d) {
    const std::vector<Fraction> p = particular_polynomial(d, k_, c_);
    const Fraction f(q.force.push.at(d));
    Fraction x, v;
    for (std::size_t j = p.size(); j-- > 0;) {
      v = v * Fraction(t) + x;
      x = x * Fraction(t) + p[j];
    }
    position_ += f * x;
    velocity_ += f * v;
    if (!p.empty()) begin += f * p[0];
    if (p.size() > 1) rate += f * p[1];
  }
  free_x_ = Fraction(q.x0) - begin;
  free_v_ = Fraction(q.v0) - rate;
}

std::array<std::optional<Rational>, 2> NumericFlow::exact() const {
  if (t_.is_zero()) return {(position_ + free_x_).constant(), (velocity_ + free_v_).constant()};
  if (!rational_) return {};
  if (k_.is_zero() && (c_.is_zero() || free_v_.is_zero()))
    return {(position_ + free_x_ + free_v_ * Fraction(t_)).constant(), (velocity_ + free_v_).constant()};
  if (free_x_.is_zero() && free_v_.is_zero()) return {position_.constant(), velocity_.constant()};
  return {};
}

std::array<Ball, 2> NumericFlow::balls(int bits) const {
  const std::vector<Ball> letters = letter_balls(extras_, bits);
  const auto ball = [&](const Fraction& f) { return ball_value(f, letters, bits); };
  const BallFlow f = rational_ ? ball_flow(k_.constant(), c_.constant(), t_, bits)
                               : ball_flow(ball(k_), ball(c_), Ball(t_, bits));
  const Ball x = ball(free_x_), v = ball(free_v_);
  return {ball(position_) + x * f.cosine + v * f.sine, ball(velocity_) + x * f.cosine_rate + v * f.sine_rate};
}

}  // namespace shortfall
