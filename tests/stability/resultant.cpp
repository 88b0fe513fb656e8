// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/resultant.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

namespace {

constexpr Letter kVariable = 0, kA = 1, kB = 2, kC = 3;

Polynomial x(int exponent = 1) { return Polynomial::letter(kVariable, exponent); }
Polynomial coefficient(Letter l) { return Polynomial::letter(l); }

}  // namespace

TEST_CASE("the resultant is the product of all differences of roots: random") {
  CHECK(rc::check([] {
    Polynomial p = 1, q = 1;
    std::vector<Rational> of_p, of_q;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
      of_p.emplace_back(*rc::gen::inRange(-9, 10), *rc::gen::inRange(1, 4));
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
      of_q.emplace_back(*rc::gen::inRange(-9, 10), *rc::gen::inRange(1, 4));
    for (const Rational& r : of_p) p *= x() - Polynomial(r);
    for (const Rational& r : of_q) q *= x() - Polynomial(r);
    Rational expected = 1;
    for (const Rational& r : of_p)
      for (const Rational& s : of_q) expected *= r - s;
    RC_ASSERT(resultant(p, q, kVariable) == Polynomial(expected));
  }));
}

TEST_CASE("resultants in letters: the discriminant of a quadratic, Sylvester's own example") {
  // p = a x^2 + b x + c: Res(p, p') = -a (b^2 - 4 a c).
  const Polynomial p = coefficient(kA) * x(2) + coefficient(kB) * x() + coefficient(kC);
  CHECK(multiple_root_condition(p, kVariable) ==
        -coefficient(kA) *
            (coefficient(kB) * coefficient(kB) - Polynomial(4) * coefficient(kA) * coefficient(kC)));
  // Where x^2 + a x + b and x - c have a common root.
  CHECK(resultant(x(2) + coefficient(kA) * x() + coefficient(kB), x() - coefficient(kC), kVariable) ==
        coefficient(kC) * coefficient(kC) + coefficient(kA) * coefficient(kC) + coefficient(kB));
}

TEST_CASE("resultants of products are products, and constants count with the other's degree") {
  const Polynomial p = x(2) + coefficient(kA), q = x() * coefficient(kB) - Polynomial(1),
                   r = x(3) - coefficient(kC);
  CHECK(resultant(p * q, r, kVariable) == resultant(p, r, kVariable) * resultant(q, r, kVariable));
  CHECK(resultant(Polynomial(3), r, kVariable) == Polynomial(27));
  CHECK(resultant(r, Polynomial(3), kVariable) == Polynomial(27));
  CHECK_THROWS_AS(resultant(Polynomial(), r, kVariable), Undefined);
  CHECK(resultant(p * q, p * r, kVariable).is_zero());
}
