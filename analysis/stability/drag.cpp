// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/drag.hpp"

#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

/// Where a rational function is negative for positive values of its letter.
std::vector<Drag::Reversal> reversals_of(const Fraction& f, Letter letter,
                                         const std::vector<AlgebraicLetter>& algebraic) {
  const CommonField field = common_field(algebraic);
  const Univariate<Algebraic> above = over_field(f.numerator(), letter, algebraic, field),
                              below = over_field(f.denominator(), letter, algebraic, field);
  std::vector<RealRoot> points;
  for (const RootOver& r : positive_roots({above, below}, field.generator)) points.push_back(r.root);
  const std::vector<Rational> samples = samples_between(points);
  std::vector<Drag::Reversal> result;
  bool negative = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool now = above.at(samples[i]).sign() * below.at(samples[i]).sign() < 0;
    if (now && !negative) result.push_back({i == 0 ? RealRoot(Rational(0)) : points[i - 1], {}});
    if (!now && negative) result.back().to = points[i - 1];
    negative = now;
  }
  return result;
}

}  // namespace

Drag drag(const Amplification& damped) {
  SquareMatrix<Fraction> m = damped.matrix;
  for (auto& row : m)
    for (Fraction& f : row) f = f.substitute(kStiffness, Fraction());
  Drag result;
  if (!damped.pair.empty() && damped.spurious_count() == 0)
    result.factor = damped.determinant().substitute(kStiffness, Fraction());
  result.windows = bounded_windows(m, kDamping, damped.algebraic);
  if (result.factor) result.reversals = reversals_of(*result.factor, kDamping, damped.algebraic);
  return result;
}

}  // namespace shortfall
