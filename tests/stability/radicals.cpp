// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/radicals.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "analysis/program/print.hpp"

using namespace shortfall;

namespace {

using Poly = Univariate<Rational>;

double value(const Expr& e) {
  using Op = Expression::Op;
  const auto of = [&](std::size_t i) { return value(e->operands[i]); };
  switch (e->op) {
    case Op::number:
      return e->value.to_double();
    case Op::negate:
      return -of(0);
    case Op::add:
      return of(0) + of(1);
    case Op::subtract:
      return of(0) - of(1);
    case Op::multiply:
      return of(0) * of(1);
    case Op::divide:
      return of(0) / of(1);
    case Op::power:
      return std::pow(of(0), of(1));
    case Op::call:
      REQUIRE(e->name == "sqrt");
      return std::sqrt(of(0));
    default:
      FAIL("an expression of radicals was expected");
      return 0;
  }
}

std::string formula(const Poly& p, std::size_t which) {
  const auto roots = real_roots(p);
  REQUIRE(which < roots.size());
  const auto e = radical_formula(roots[which]);
  return e ? print(*e) : "none";
}

}  // namespace

TEST_CASE("roots as people write them") {
  CHECK(formula(Poly({-8, 0, 1}), 1) == "2*sqrt(2)");
  CHECK(formula(Poly({-3, 2}), 0) == "3/2");
  CHECK(formula(Poly({-1, -1, 1}), 1) == "(1 + sqrt(5))/2");
  CHECK(formula(Poly({-1, -1, 1}), 0) == "(1 - sqrt(5))/2");
  CHECK(formula(Poly({-2, 0, 0, 1}), 0) == "2^(1/3)");
  CHECK(formula(Poly({1, 0, -10, 0, 1}), 3) == "sqrt(3) + sqrt(2)");
  CHECK(formula(Poly({-1, -1, 0, 0, 0, 1}), 0) == "none");  // x^5 - x - 1, of Galois group S5
  // sqrt(1 + sqrt(13)), whose conjugate is not real.
  CHECK(formula(Poly({-12, 0, -2, 0, 1}), 1) == "sqrt(1 + sqrt(13))");
  // The limit of drag for the classical method: the only real root of x^3 - 4 x^2 + 12 x - 24, 2.785...
  CHECK(real_roots(Poly({-24, 12, -4, 1})).front().decimal(12) == "2.785293563405");
}

TEST_CASE("square roots of rationals, squares taken out") {
  CHECK(print(square_root_formula(Rational(8))) == "2*sqrt(2)");
  CHECK(print(square_root_formula(Rational(2, 3))) == "sqrt(6)/3");
  CHECK(print(square_root_formula(Rational(9, 4))) == "3/2");
  CHECK(print(square_root_formula(Rational(0))) == "0");
}

TEST_CASE("a formula has the value of its root: random polynomials up to degree 6") {
  int formulas = 0;
  CHECK(rc::check([&] {
    const int stride = *rc::gen::inRange(1, 4);
    std::vector<Rational> c(static_cast<std::size_t>(3 * stride) + 1);
    for (std::size_t k = 0; k < c.size(); k += static_cast<std::size_t>(stride))
      c[k] = Rational(*rc::gen::inRange(-12, 13));
    const Poly p(c);
    if (p.degree() < 1) return;
    for (const RealRoot& r : real_roots(p)) {
      const auto e = radical_formula(r);
      if (!e) continue;
      ++formulas;
      // Nested roots of nearly equal numbers lose digits in binary64.
      RC_ASSERT(std::abs(value(*e) - r.to_double()) <= 1e-6 * (1 + std::abs(r.to_double())));
    }
  }));
  CHECK(formulas > 50);
}

TEST_CASE("a number's polynomial as a formula") {
  CHECK(print(polynomial_formula(Poly({-24, 12, -4, 1}), "x")) == "x^3 - 4*x^2 + 12*x - 24");
  CHECK(print(polynomial_formula(Poly({Rational(1), 0, -2}), "z")) == "-2*z^2 + 1");
}
