// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/univariate.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/sturm.hpp"
#include "analysis/stability/quotient.hpp"

using namespace shortfall;

namespace {

using Poly = Univariate<Rational>;

Rational random_rational() { return {*rc::gen::inRange(-30, 31), *rc::gen::inRange(1, 7)}; }

Poly random_polynomial(int degree) {
  std::vector<Rational> c;
  for (int k = 0; k <= degree; ++k) c.push_back(random_rational());
  return c;
}

Poly linear(const Rational& root) { return Poly({-root, 1}); }

}  // namespace

TEST_CASE("quotient and remainder: a = q b + r with deg r < deg b, for random polynomials") {
  CHECK(rc::check([] {
    const Poly a = random_polynomial(*rc::gen::inRange(0, 8)), b = random_polynomial(*rc::gen::inRange(0, 5));
    if (b.is_zero()) return;
    const auto [q, r] = divided(a, b);
    RC_ASSERT(q * b + r == a);
    RC_ASSERT(r.degree() < b.degree());
  }));
  CHECK_THROWS_AS(divided(Poly({1}), Poly()), Undefined);
}

TEST_CASE("the greatest common divisor divides both and contains every shared factor") {
  CHECK(rc::check([] {
    const Poly shared = random_polynomial(2), a = random_polynomial(3) * shared,
               b = random_polynomial(3) * shared;
    if (a.is_zero() || b.is_zero()) return;
    const Poly g = gcd(a, b);
    RC_ASSERT(divided(a, g).second.is_zero());
    RC_ASSERT(divided(b, g).second.is_zero());
    RC_ASSERT(divided(g, shared).second.is_zero());
    RC_ASSERT(g.leading() == Rational(1));
  }));
}

TEST_CASE("square-free parts multiply up to the polynomial and share no factor") {
  CHECK(rc::check([] {
    Poly p({random_rational() + 31});
    for (int i = 0; i < 4; ++i)
      for (int k = *rc::gen::inRange(0, 4); k > 0; --k) p = p * linear(random_rational());
    Poly product({p.leading()});
    for (const auto& [part, multiplicity] : squarefree_parts(p)) {
      RC_ASSERT(gcd(part, part.derivative()).degree() == 0);
      for (int k = 0; k < multiplicity; ++k) product = product * part;
    }
    RC_ASSERT(product == p);
  }));
}

TEST_CASE("reversal, value and derivative") {
  const Poly p({1, -2, 3});  // 1 - 2 x + 3 x^2
  CHECK(p.reversed() == Poly({3, -2, 1}));
  CHECK(p.at(Rational(1, 3)) == Rational(2, 3));
  CHECK(p.derivative() == Poly({-2, 6}));
  CHECK(Poly({1, 0, 0}).degree() == 0);
  CHECK(Poly({0}).is_zero());
}

TEST_CASE("Sturm's sequence counts the roots that a polynomial was made of") {
  CHECK(rc::check([] {
    std::vector<Rational> roots;
    Poly p({1});
    for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
      const Rational r = random_rational();
      if (std::ranges::find(roots, r) != roots.end()) continue;
      roots.push_back(r);
      p = p * linear(r);
    }
    // Two complex roots besides: x^2 + b^2.
    const Rational b = random_rational();
    if (!b.is_zero()) p = p * Poly({b * b, 0, 1});
    if (p.degree() < 1) return;
    const Sturm<Rational> sturm(p);
    RC_ASSERT(sturm.roots() == static_cast<int>(roots.size()));
    const Rational low = random_rational(), high = low + random_rational().abs() + 1;
    const auto between =
        std::ranges::count_if(roots, [&](const Rational& r) { return low < r && r <= high; });
    RC_ASSERT(sturm.roots_between(low, high) == between);
    RC_ASSERT(sturm.roots_above(low) ==
              std::ranges::count_if(roots, [&](const Rational& r) { return r > low; }));
  }));
}

TEST_CASE("rational functions are a field in lowest terms") {
  using Function = Quotient<Rational>;
  const auto random_function = [] {
    const Poly below = random_polynomial(2);
    return below.is_zero() ? Function(random_polynomial(2)) : Function(random_polynomial(2), below);
  };
  CHECK(rc::check([&] {
    const Function a = random_function(), b = random_function(), c = random_function();
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    if (!b.is_zero()) RC_ASSERT(a / b * b == a);
    RC_ASSERT(gcd(a.numerator(), a.denominator()).degree() < 1);
    RC_ASSERT(a.denominator().leading() == Rational(1));
  }));
  CHECK_THROWS_AS(Function(Poly({1}), Poly()), Undefined);
  CHECK_THROWS_AS(Function(1) / Function(0), Undefined);
}
