// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/growth_at_root.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/stability/windows.hpp"

using namespace shortfall;

namespace {

Polynomial some_polynomial(int degree) {
  Polynomial p;
  for (int k = 0; k <= degree; ++k)
    p += Polynomial(Rational(*rc::gen::inRange(-6, 7), *rc::gen::inRange(1, 4))) *
         Polynomial::letter(kStiffness, k);
  return p;
}

Fraction some_entry() {
  const Polynomial below = *rc::gen::inRange(0, 3) == 0 ? some_polynomial(1) : Polynomial(1);
  return Fraction(some_polynomial(*rc::gen::inRange(0, 3)), below.is_zero() ? Polynomial(1) : below);
}

bool same(const PowerGrowth& a, const PowerGrowth& b) {
  if (a.kind != b.kind) return false;
  if (a.kind == PowerGrowth::Kind::exponential) return true;
  if (a.degree != b.degree || a.decays != b.decays || a.inside != b.inside ||
      a.circle.size() != b.circle.size())
    return false;
  for (std::size_t i = 0; i < a.circle.size(); ++i) {
    const CircleEigenvalues &x = a.circle[i], &y = b.circle[i];
    if (x.kind != y.kind || x.count != y.count || x.multiplicity != y.multiplicity ||
        x.largest_block != y.largest_block || x.cosine != y.cosine)
      return false;
  }
  return true;
}

/// Compares at the irrational positive roots of the numerators of these, where nothing has a pole.
void compare_at_roots(const SquareMatrix<Fraction>& m, const std::vector<Fraction>& at) {
  std::vector<Univariate<Rational>> polynomials;
  for (const Fraction& f : at)
    if (f.numerator().contains(kStiffness)) polynomials.push_back(univariate(f.numerator(), kStiffness));
  for (const RealRoot& root : positive_roots(polynomials)) {
    if (root.is_rational()) continue;
    bool pole = false;
    for (const auto& row : m)
      for (const Fraction& f : row)
        pole = pole || sign_at_root(Fraction(f.denominator()), kStiffness, root) == 0;
    if (pole) continue;
    RC_ASSERT(same(growth_at_root(m, kStiffness, root), power_growth(matrix_at(m, kStiffness, root))));
  }
}

}  // namespace

TEST_CASE(
    "two rows at a root: signs decide what the number field decides, where eigenvalues reach the circle and "
    "elsewhere") {
  CHECK(rc::check([] {
    SquareMatrix<Fraction> m{{some_entry(), some_entry()}, {some_entry(), some_entry()}};
    switch (*rc::gen::inRange(0, 4)) {
      case 0:  // determinant 1, as of a symplectic step
        if (m[0][0].is_zero()) return;
        m[1][1] = (Fraction(1) + m[0][1] * m[1][0]) / m[0][0];
        break;
      case 1:  // triangular
        m[1][0] = 0;
        break;
      case 2:  // a double eigenvalue that may lose its Jordan block
        m[1][1] = m[0][0];
        m[1][0] = m[0][1] * Fraction(*rc::gen::inRange(-2, 3));
        break;
      default:
        break;
    }
    const Fraction t = m[0][0] + m[1][1], d = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    compare_at_roots(m, {Fraction(1) - d, Fraction(1) - t + d, Fraction(1) + t + d, d, t, m[0][1],
                         m[0][0] - Fraction(1), some_entry()});
  }));
}

TEST_CASE("one row at a root") {
  CHECK(rc::check([] {
    const SquareMatrix<Fraction> m{{some_entry()}};
    compare_at_roots(m, {m[0][0], m[0][0] - Fraction(1), m[0][0] + Fraction(1), some_entry()});
  }));
}

TEST_CASE("a double eigenvalue is semisimple exactly where the rest vanishes, however near that is") {
  // At y = sqrt(2): M = [[-1, y^2 - 2], [0, -1]] is -1; a little beside it is not.
  const RealRoot root(Univariate<Rational>({-2, 0, 1}), 1, 2);
  const Fraction y = Fraction::letter(kStiffness);
  const PowerGrowth flat = growth_at_root({{-1, y * y - Fraction(2)}, {0, -1}}, kStiffness, root);
  CHECK(flat.bounded());
  CHECK(flat.circle.at(0).largest_block == 1);
  const Rational tiny = Rational(10).pow(-400);
  const PowerGrowth steep = growth_at_root({{-1, y * y - Fraction(2 + tiny)}, {0, -1}}, kStiffness, root);
  CHECK(steep.kind == PowerGrowth::Kind::polynomial);
  CHECK(sign_at_root(y * y - Fraction(2 + tiny), kStiffness, root) == -1);
  CHECK(sign_at_root((y * y - Fraction(2)) * y, kStiffness, root) == 0);
  CHECK_THROWS_AS(growth_at_root({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, kStiffness, root), Error);
}
