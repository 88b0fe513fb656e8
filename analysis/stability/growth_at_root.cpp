// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/growth_at_root.hpp"

#include <optional>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/stability/windows.hpp"

namespace shortfall {

namespace {

constexpr int kFirstBits = 128;
constexpr int kBitsForZero = 512;  // from here on division is the cheaper question

/// p at the numbers of a ball.
Ball value(const Univariate<Rational>& p, const Ball& x, int bits) {
  Ball sum(0, bits);
  for (int k = p.degree(); k >= 0; --k) {
    sum *= x;
    sum += Ball(p[k], bits);
  }
  return sum;
}

int sign_at(const Polynomial& f, Letter letter, const RealRoot& root) {
  if (f.is_constant()) return f.constant().sign();
  const Univariate<Rational> p = univariate(f, letter);
  bool not_zero = false;
  RealRoot narrow = root;
  for (int bits = kFirstBits;; bits *= 2) {
    if (bits >= kBitsForZero && !not_zero) {
      Polynomial quotient;
      if (divides(Polynomial::in(letter, root.polynomial().coefficients()), f, &quotient)) return 0;
      not_zero = true;
    }
    narrow = narrow.refined(Rational(1, 2).pow(bits));
    const Ball x = hull(Ball(narrow.low(), 2 * bits), Ball(narrow.high(), 2 * bits));
    if (const std::optional<int> sign = value(p, x, 2 * bits).sign()) return *sign;
  }
}

/// The number that a rational function is at the root, when it is a rational one.
std::optional<Rational> rational_at(const Fraction& f, Letter letter, const RealRoot& root) {
  const auto generator = std::make_shared<const RealRoot>(root);
  const Algebraic at = Algebraic(univariate(f.numerator(), letter), generator) /
                       Algebraic(univariate(f.denominator(), letter), generator);
  return at.is_rational() ? std::optional(at.rational()) : std::nullopt;
}

PowerGrowth exponential() {
  PowerGrowth growth;
  growth.kind = PowerGrowth::Kind::exponential;
  return growth;
}

using Kind = CircleEigenvalues::Kind;

PowerGrowth one_row(const Fraction& m, Letter letter, const RealRoot& root) {
  const int above = sign_at_root(Fraction(1) - m, letter, root),
            below = sign_at_root(Fraction(1) + m, letter, root);
  if (above < 0 || below < 0) return exponential();
  PowerGrowth growth;
  if (above == 0 || below == 0) {
    growth.circle.push_back({above == 0 ? Kind::plus_one : Kind::minus_one, 1, 1, 1, {}});
    return growth;
  }
  growth.decays = true;
  growth.inside = sign_at_root(m, letter, root) != 0;
  return growth;
}

/// A double eigenvalue `value`, 1 or -1: semisimple only where the matrix is a multiple of the identity.
PowerGrowth twice(const SquareMatrix<Fraction>& m, int value, Letter letter, const RealRoot& root) {
  bool diagonal = true;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      diagonal = diagonal && sign_at_root(i == j ? m[i][j] - Fraction(value) : m[i][j], letter, root) == 0;
  PowerGrowth growth;
  growth.circle.push_back({value == 1 ? Kind::plus_one : Kind::minus_one, 1, 2, diagonal ? 1 : 2, {}});
  if (!diagonal) {
    growth.degree = 1;
    growth.kind = PowerGrowth::Kind::polynomial;
  }
  return growth;
}

PowerGrowth two_rows(const SquareMatrix<Fraction>& m, Letter letter, const RealRoot& root) {
  const Fraction trace = m[0][0] + m[1][1], determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const auto sign = [&](const Fraction& f) { return sign_at_root(f, letter, root); };
  const int area = sign(Fraction(1) - determinant);
  // The characteristic polynomial at 1 and at -1.
  const int at_one = sign(Fraction(1) - trace + determinant),
            at_minus_one = sign(Fraction(1) + trace + determinant);
  if (area < 0 || at_one < 0 || at_minus_one < 0) return exponential();
  if (area == 0 && at_one == 0) return twice(m, 1, letter, root);
  if (area == 0 && at_minus_one == 0) return twice(m, -1, letter, root);
  PowerGrowth growth;
  if (area == 0) {
    growth.circle.push_back({Kind::pairs, 2, 1, 1, rational_at(trace / Fraction(2), letter, root)});
    return growth;
  }
  const bool singular = sign(determinant) == 0;
  if (at_one == 0) growth.circle.push_back({Kind::plus_one, 1, 1, 1, {}});
  if (at_minus_one == 0) growth.circle.push_back({Kind::minus_one, 1, 1, 1, {}});
  growth.decays = growth.circle.empty();
  const int left = 2 - static_cast<int>(growth.circle.size());  // inside, 0 counted
  growth.inside = !singular || left == 0 ? left : left == 1 ? 0 : sign(trace) != 0;
  return growth;
}

}  // namespace

int sign_at_root(const Fraction& f, Letter letter, const RealRoot& root) {
  if (f.is_zero()) return 0;
  const int above = sign_at(f.numerator(), letter, root);
  return above == 0 ? 0 : above * sign_at(f.denominator(), letter, root);
}

PowerGrowth growth_at_root(const SquareMatrix<Fraction>& matrix, Letter letter, const RealRoot& root) {
  if (matrix.size() == 1) return one_row(matrix[0][0], letter, root);
  if (matrix.size() == 2) return two_rows(matrix, letter, root);
  throw Error("growth_at_root is for one or two rows");
}

}  // namespace shortfall
