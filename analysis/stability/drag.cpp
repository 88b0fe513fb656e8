// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/drag.hpp"

#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

/// The smallest positive value of the letter at which a rational function changes its sign.
std::optional<RealRoot> first_sign_change(const Fraction& f, Letter letter) {
  const std::vector<RealRoot> points = positive_roots({univariate(f.numerator(), letter), univariate(f.denominator(), letter)});
  const std::vector<Rational> samples = samples_between(points);
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (f.evaluate({{letter, samples[i]}}).sign() != f.evaluate({{letter, samples[0]}}).sign()) return points[i - 1];
  return std::nullopt;
}

}  // namespace

Drag drag(const Amplification& damped) {
  SquareMatrix<Fraction> m = damped.matrix;
  for (auto& row : m)
    for (Fraction& f : row) f = f.substitute(kStiffness, Fraction());
  Drag result;
  if (!damped.pair.empty() && damped.spurious_count() == 0) result.factor = damped.determinant().substitute(kStiffness, Fraction());
  result.windows = bounded_windows(m, kDamping);
  if (result.factor) result.overshoots = first_sign_change(*result.factor, kDamping);
  return result;
}

}  // namespace shortfall
