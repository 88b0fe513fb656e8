// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/real_roots.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "analysis/algebra/algebraic.hpp"
#include "analysis/stability/isolation.hpp"

using namespace shortfall;

namespace {

using Poly = Univariate<Rational>;

Poly product_of(const std::vector<Rational>& roots) {
  Poly p({1});
  for (const Rational& r : roots) p = p * Poly({-r, 1});
  return p;
}

/// Chebyshev's polynomial T_n: its roots are cos((2k - 1) pi/(2n)).
Poly chebyshev(int n) {
  Poly before({1}), now({0, 1});
  if (n == 0) return before;
  for (int k = 1; k < n; ++k) before = std::exchange(now, Poly({0, 2}) * now - before);
  return now;
}

}  // namespace

TEST_CASE("rational roots come back exactly, once each, in order: random") {
  CHECK(rc::check([] {
    std::vector<Rational> roots;
    for (int i = *rc::gen::inRange(1, 7); i > 0; --i)
      roots.emplace_back(*rc::gen::inRange(-40, 41), *rc::gen::inRange(1, 9));
    const std::vector<RealRoot> found = real_roots(product_of(roots));
    std::ranges::sort(roots);
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    RC_ASSERT(found.size() == roots.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      RC_ASSERT(found[i].is_rational());
      RC_ASSERT(found[i].rational() == roots[i]);
    }
  }));
}

TEST_CASE("Wilkinson's polynomial of degree 20, plus 2^-23 x^19: ten real roots are left") {
  std::vector<Rational> roots;
  for (int k = 1; k <= 20; ++k) roots.emplace_back(k);
  Poly p = product_of(roots);
  CHECK(real_roots(p).size() == 20);
  std::vector<Rational> disturbed = p.coefficients();
  disturbed[19] -= Rational(1) / Rational(2).pow(23);
  const auto found = real_roots(Poly(disturbed));
  // source: Wilkinson (1963), Rounding Errors in Algebraic Processes: 20.847, 8.917, 8.007, ... and ten
  // complex ones.
  CHECK(found.size() == 10);
  CHECK(found.back().decimal(9) == "20.846908101");
  CHECK(found[7].decimal(9) == "8.007267603");
  CHECK(found[8].decimal(9) == "8.917250249");
}

TEST_CASE("the roots of Chebyshev's polynomials are cosines") {
  for (const int n : {5, 8, 13}) {
    const auto found = real_roots(chebyshev(n));
    REQUIRE(static_cast<int>(found.size()) == n);
    for (int k = 0; k < n; ++k)
      CHECK(found[static_cast<std::size_t>(k)].to_double() ==
            doctest::Approx(-std::cos((2 * k + 1) * std::acos(-1.0) / (2 * n))).epsilon(1e-14));
  }
}

TEST_CASE("decimals are correctly rounded: the polynomial changes its sign within half a unit") {
  CHECK(rc::check([] {
    std::vector<Rational> c;
    for (int k = 0; k <= 5; ++k) c.emplace_back(*rc::gen::inRange(-20, 21));
    const Poly p(c);
    if (p.degree() < 1) return;
    for (const RealRoot& r : real_roots(p)) {
      const Rational shown = Rational::parse(r.decimal(25)), half = Rational(1, 2) / Rational(10).pow(25);
      RC_ASSERT(r.compare(shown - half) >= 0);
      RC_ASSERT(r.compare(shown + half) <= 0);
      if (!r.is_rational())
        RC_ASSERT(r.polynomial().at(shown - half).sign() * r.polynomial().at(shown + half).sign() == -1);
      RC_ASSERT(std::abs(r.to_double() - shown.to_double()) <= 1e-15 * std::abs(shown.to_double()) + 1e-24);
    }
  }));
}

TEST_CASE("comparison is an order, and equal numbers from different polynomials are equal") {
  const auto first = positive_roots({Poly({-2, 0, 1})}),
             second = positive_roots({Poly({-2, 0, 1}) * Poly({-3, 0, 1})});
  REQUIRE(first.size() == 1);
  REQUIRE(second.size() == 2);
  CHECK(first[0] == second[0]);
  CHECK(first[0].compare(second[1]) == -1);
  CHECK(first[0].compare(Rational::parse("1.41421356237309504880168")) == 1);
  CHECK(first[0].compare(Rational::parse("1.41421356237309504880169")) == -1);
  // Very close: sqrt(2) and a rational 10^-40 away.
  const Rational close = Rational::parse(first[0].decimal(40));
  CHECK(first[0].compare(close) != 0);
}

TEST_CASE("square roots and multiples are exact") {
  const RealRoot eight(8);
  CHECK(square_root(eight).polynomial() == Poly({-8, 0, 1}));
  CHECK(square_root(RealRoot(Rational(9, 4))).rational() == Rational(3, 2));
  CHECK(scaled(square_root(eight), Rational(1, 2)).polynomial() == Poly({-2, 0, 1}));
  CHECK_THROWS_AS(square_root(RealRoot(-1)), Undefined);
  CHECK_THROWS_AS(RealRoot(Poly({-2, 0, 1}), 2, 3), Error);
  CHECK(square_root(eight).rational_square() == Rational(8));
}

TEST_CASE("isolating decimals hold one root and are neighbours") {
  const auto shown = [](const RealRoot& r) { return isolation(r).low + ".." + isolation(r).high; };
  CHECK(shown(square_root(RealRoot(8))) == "2.8..2.9");
  // (x^2 - 2)^2 = 1/10^6: the two positive roots agree to three digits.
  const auto close = positive_roots({Poly({Rational(4) - Rational(2, 1'000'000'000), 0, -4, 0, 1})});
  REQUIRE(close.size() == 2);
  CHECK(close[0].compare(close[1]) == -1);
  const Isolation low = isolation(close[0]);
  CHECK(close[0].compare(Rational::parse(low.low)) == 1);
  CHECK(close[0].compare(Rational::parse(low.high)) == -1);
  CHECK(close[1].compare(Rational::parse(low.high)) == 1);
}

TEST_CASE("a number field is an ordered field: the real root of x^3 - x - 1") {
  const auto generator = std::make_shared<const RealRoot>(real_roots(Poly({-1, -1, 0, 1})).front());
  const auto element = [&] {
    return Algebraic(
        Poly({*rc::gen::inRange(-20, 21), *rc::gen::inRange(-20, 21), *rc::gen::inRange(-20, 21)}),
        generator);
  };
  const double plastic = 1.3247179572447460260;
  CHECK(generator->to_double() == plastic);
  CHECK(rc::check([&] {
    const Algebraic a = element(), b = element(), c = element();
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT(a * b == b * a);
    if (!b.is_zero()) RC_ASSERT(a / b * b == a);
    RC_ASSERT((a < b) + (b < a) + (a == b) == 1);
    const auto value = [&](const Algebraic& x) {
      double sum = 0;
      for (int k = x.polynomial().degree(); k >= 0; --k) sum = sum * plastic + x.polynomial()[k].to_double();
      return sum;
    };
    if (std::abs(value(a)) > 1e-9) RC_ASSERT(a.sign() == (value(a) > 0) - (value(a) < 0));
    RC_ASSERT(std::abs(value(a * b) - value(a) * value(b)) <= 1e-9 * (1 + std::abs(value(a) * value(b))));
  }));
  CHECK_THROWS_AS(Algebraic(1) / Algebraic(0), Undefined);
}

TEST_CASE("the simplest rational in an interval") {
  CHECK(simplest_between(Rational(0), Rational(1, 3)) == Rational(1, 4));
  CHECK(simplest_between(Rational(5, 2), Rational(7, 2)) == Rational(3));
  CHECK(simplest_between(Rational::parse("3.14"), Rational::parse("3.15")) == Rational(22, 7));
  CHECK(rc::check([] {
    const Rational low(*rc::gen::inRange(0, 500), *rc::gen::inRange(1, 60));
    const Rational high = low + Rational(1, *rc::gen::inRange(1, 500));
    const Rational middle = simplest_between(low, high);
    RC_ASSERT(low < middle);
    RC_ASSERT(middle < high);
    // None of smaller denominator lies there.
    for (Rational d = 1; d < middle.denominator(); d += 1) RC_ASSERT(!((low * d).floor() + 1 < high * d));
  }));
}
