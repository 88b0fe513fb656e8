// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/root_count.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/algebra/sturm.hpp"

using namespace shortfall;

namespace {

using Poly = Univariate<Rational>;

Rational some_rational(int size = 30) { return {*rc::gen::inRange(-size, size), *rc::gen::inRange(1, 12)}; }

Poly some_polynomial(int degree) {
  std::vector<Rational> coefficients;
  for (int k = 0; k <= degree; ++k) coefficients.push_back(some_rational());
  return coefficients;
}

}  // namespace

TEST_CASE("the sign of a polynomial in whole numbers is that of its value in fractions") {
  CHECK(rc::check([] {
    const Poly p = some_polynomial(*rc::gen::inRange(0, 8));
    const Rational x = some_rational(1000);
    RC_ASSERT(ExactSign(p)(x) == p.at(x).sign());
  }));
  CHECK(ExactSign(Poly())(3) == 0);
}

TEST_CASE("a root is refined to thousands of bits, and stays between its ends") {
  CHECK(rc::check([] {
    const Poly p = some_polynomial(*rc::gen::inRange(2, 7));
    if (p.is_zero() || p.degree() < 1) return;
    for (const RealRoot& root : real_roots(p)) {
      const int bits = *rc::gen::inRange(1, 3000);
      const Rational width = Rational(1, 2).pow(bits);
      const RealRoot narrow = root.refined(width);
      RC_ASSERT(narrow.high() - narrow.low() <= width);
      RC_ASSERT(root.low() <= narrow.low());
      RC_ASSERT(narrow.high() <= root.high());
      RC_ASSERT(narrow.is_rational() ||
                root.polynomial().at(narrow.low()).sign() * root.polynomial().at(narrow.high()).sign() < 0);
    }
  }));
}

TEST_CASE("roots are counted as Sturm's sequence counts them, also from and to a root") {
  CHECK(rc::check([] {
    // Some rational roots, near each other at times, and a factor that may have irrational ones.
    Poly p = some_polynomial(*rc::gen::inRange(0, 5));
    if (p.is_zero()) return;
    std::vector<Rational> roots;
    for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
      const Rational close(1, 1'000'000'007);
      roots.push_back(!roots.empty() && *rc::gen::arbitrary<bool>() ? roots.back() + close : some_rational());
      p = p * Poly({-roots.back(), 1});
    }
    if (p.degree() < 1 || gcd(p, p.derivative()).degree() > 0) return;
    const RootCount count(p);
    const Sturm<Rational> sturm(p);
    RC_ASSERT(count.roots() == sturm.roots());
    std::vector<Rational> ends{some_rational(), some_rational(1000), -1000, 1000};
    ends.insert(ends.end(), roots.begin(), roots.end());
    for (const Rational& low : ends)
      for (const Rational& high : ends)
        if (low <= high) RC_ASSERT(count.roots_between(low, high) == sturm.roots_between(low, high));
  }));
}

TEST_CASE("roots as close as 1e-60 are told apart, and multiple ones are refused") {
  const Rational tiny = Rational(10).pow(-60);
  const Poly p = Poly({-1, 1}) * Poly({-1 - tiny, 1}) * Poly({1, 0, 1});
  const RootCount count(p);
  CHECK(count.roots() == 2);
  CHECK(count.roots_between(1, 2) == 1);
  CHECK(count.roots_between(1 - tiny, 1 + tiny / 2) == 1);
  CHECK(count.roots_between(1 + tiny, 5) == 0);
  CHECK(RootCount(Poly({7})).roots() == 0);
  CHECK_THROWS_AS(RootCount(Poly({1, 2, 1})), Error);
  CHECK_THROWS_AS(RootCount(Poly({0})), Error);
}

TEST_CASE("the square root of a positive algebraic number is the positive number whose square it is") {
  CHECK(rc::check([] {
    const Poly p = some_polynomial(*rc::gen::inRange(1, 5));
    if (p.degree() < 1) return;
    std::vector<RealRoot> numbers = positive_roots({p});
    const Rational r = some_rational().abs() + 1;
    numbers.emplace_back(r);
    numbers.emplace_back(r * r);
    for (const RealRoot& number : numbers) {
      const RealRoot root = square_root(number);
      RC_ASSERT(root.compare(0) == 1);
      RC_ASSERT(root.low().sign() > 0);
      // Its polynomial divides p(z^2), and the square is nearer to the number than to any other root of p.
      const Rational width = Rational(10).pow(-30);
      const RealRoot narrow = root.refined(width);
      RC_ASSERT(number.compare(narrow.low() * narrow.low() - width) == 1);
      RC_ASSERT(number.compare(narrow.high() * narrow.high() + width) == -1);
      std::vector<Rational> doubled;
      for (const Rational& c : number.polynomial().coefficients()) {
        if (!doubled.empty()) doubled.push_back(0);
        doubled.push_back(c);
      }
      RC_ASSERT(divided(Poly(doubled), root.polynomial()).second.is_zero());
    }
  }));
  CHECK(square_root(RealRoot(Rational(9, 4))).rational() == Rational(3, 2));
  CHECK_THROWS_AS(square_root(RealRoot(-1)), Undefined);
}
