// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/ball.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

TEST_CASE("arithmetic with balls holds the exact result, at every precision") {
  CHECK(rc::check([](const Rational& a, const Rational& b) {
    const int bits = *random::whole(2, 200);
    const Ball x(a, bits), y(b, bits);
    RC_ASSERT(x.contains(a));
    RC_ASSERT((x + y).contains(a + b));
    RC_ASSERT((x - y).contains(a - b));
    RC_ASSERT((x * y).contains(a * b));
    RC_ASSERT((-x).contains(-a));
    RC_ASSERT(abs(x).contains(a.abs()));
    RC_ASSERT(pow(x, 3).contains(a.pow(3)));
    Ball sum = x;
    sum.add_product(x, y);
    RC_ASSERT(sum.contains(a + a * b));
    if (!b.is_zero() && !y.contains_zero()) RC_ASSERT((x / y).contains(a / b));
    RC_ASSERT(hull(x, y).contains(a));
    RC_ASSERT(hull(x, y).contains(b));
    RC_ASSERT(hull(x, y).contains((a + b) / 2));
  }));
}

TEST_CASE("the sign is said only when all of the ball has it") {
  CHECK(Ball(Rational(1, 3), 20).sign() == 1);
  CHECK(Ball(Rational(-1, 3), 20).sign() == -1);
  CHECK(Ball(0, 20).sign() == 0);
  const Ball third(Rational(1, 3), 20);
  const Ball nothing = third - third;
  CHECK_FALSE(nothing.sign().has_value());
  CHECK(nothing.contains_zero());
  CHECK_FALSE(nothing.is_zero());
  CHECK((Ball(3, 20) - Ball(3, 20)).is_zero());
  CHECK_FALSE((Ball(1, 20) / nothing).is_finite());
  CHECK_FALSE((Ball(1, 20) / nothing).significant(5).has_value());
}

TEST_CASE("digits of a ball are those of the number inside, or none") {
  CHECK(rc::check([](const Rational& a) {
    const int bits = *random::whole(4, 300);
    const int digits = *random::whole(1, 60);
    const auto shown = Ball(a, bits).significant(digits);
    if (shown) RC_ASSERT(*shown == a.significant(digits));
    RC_ASSERT(Ball(a, 400).significant(digits).has_value() || a.is_zero() || !Ball(a, 400).is_exact());
  }));
  // Exactly half way: decided, away from zero.
  CHECK(Ball(Rational(-4611686018427387905), 400).significant(18) ==
        Rational(-4611686018427387905).significant(18));
  CHECK(Ball(Rational(1, 3), 60).significant(5) == "0.33333");
  CHECK_FALSE(Ball(Rational(1, 3), 60).significant(50).has_value());
  CHECK(Ball(Rational(-2, 3), 300).significant(3) == "-0.667");
  CHECK(Ball(Rational::parse("999999.9"), 300).significant(4) == "1000000");
  CHECK(Ball(Rational::parse("1e30"), 300).significant(3) == "1.00e+30");
  CHECK(exp(Ball(Rational::parse("-1e15"), 300)).significant(6) == "1.48713e-434294481903252");
}

TEST_CASE("functions agree with MPFR's") {
  const Precision precision(100);
  struct Pair {
    std::function<Ball(const Ball&)> ours;
    std::function<Real(const Real&)> theirs;
  };
  const Pair pairs[] = {
      {[](const Ball& x) { return sqrt(x); }, [](const Real& x) { return Real(sqrt(x)); }},
      {[](const Ball& x) { return exp(x); }, [](const Real& x) { return Real(exp(x)); }},
      {[](const Ball& x) { return log(x); }, [](const Real& x) { return Real(log(x)); }},
      {[](const Ball& x) { return sin(x); }, [](const Real& x) { return Real(sin(x)); }},
      {[](const Ball& x) { return cos(x); }, [](const Real& x) { return Real(cos(x)); }},
      {[](const Ball& x) { return sinh(x); }, [](const Real& x) { return Real(sinh(x)); }},
      {[](const Ball& x) { return cosh(x); }, [](const Real& x) { return Real(cosh(x)); }},
  };
  for (const Pair& pair : pairs)
    for (int i = 1; i < 40; ++i) {
      const Rational at(7 * i, 11);
      const std::string theirs = pair.theirs(real(at, 100)).str(60, std::ios_base::scientific);
      const auto ours = pair.ours(Ball(at, 400)).significant(50);
      REQUIRE(ours);
      const Rational gap = Rational::parse(*ours) - Rational::parse(theirs);
      CHECK(gap.abs() <= Rational::parse(theirs).abs() * Rational(10).pow(-49));
    }
}

TEST_CASE("the radius is bounded from above") {
  CHECK(Ball(3, 50).radius() == "0");
  const Ball third(Rational(1, 3), 60);
  const Rational bound = Rational::parse(third.radius());
  CHECK((third.midpoint() - Rational(1, 3)).abs() <= bound);
  CHECK(bound < Rational::parse("1e-17"));
  CHECK(bound.sign() > 0);
}

TEST_CASE("the larger precision wins, copies and moves are values") {
  Ball a(Rational(1, 3), 50);
  const Ball b(Rational(1, 7), 90);
  CHECK((a + b).bits() == 90);
  Ball copy = a;
  copy += b;
  CHECK(a.contains(Rational(1, 3)));
  CHECK_FALSE(a.contains(Rational(10, 21)));
  CHECK(copy.contains(Rational(10, 21)));
  const Ball moved = std::move(copy);
  CHECK(moved.contains(Rational(10, 21)));
  a = moved;
  CHECK(a.overlaps(moved));
  CHECK_FALSE(a.overlaps(b));
  CHECK_THROWS_AS(Ball(1, 1), Error);
}
