// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/surd.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

constexpr int kDigits = 200;

Real valued(const Rational& r, int digits = kDigits) { return real(r, digits); }

/// The number by MPFR's square root.
Real valued(const Surd& s, int digits = kDigits) {
  return valued(s.rational_part(), digits) +
         valued(s.root_part(), digits) * sqrt(valued(s.radicand(), digits));
}

rc::Gen<Rational> part() {
  return rc::gen::oneOf(random::small_rational(),
                        random::quotient(random::integer_of_digits(20), random::integer_of_digits(12)));
}
rc::Gen<Rational> radicand() {
  return rc::gen::map(part(), [](const Rational& r) { return r.abs(); });
}
Surd some(const Rational& d) { return Surd(*part(), *part(), d); }

int sign(const Real& r) { return (r > 0) - (r < 0); }

}  // namespace

TEST_CASE("surds over one root obey the laws of a field") {
  CHECK(rc::check([] {
    const Rational d = *radicand();
    const Surd a = some(d), b = some(d), c = some(d);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    if (!a.is_zero()) RC_ASSERT((a / a) == 1);
    if (!a.is_zero()) RC_ASSERT(b / a * a == b);
  }));
}

TEST_CASE("the square of a square root is the number") {
  CHECK(rc::check([] {
    const Rational d = *radicand();
    const Surd root = Surd::sqrt(d);
    RC_ASSERT(root * root == Surd(d));
    RC_ASSERT((root * root).is_rational());
    RC_ASSERT(Surd::sqrt(d * d).is_rational());
    RC_ASSERT(Surd::sqrt(d * d) == Surd(d));
  }));
}

TEST_CASE("surds have the sign and the floor of their values to 200 digits") {
  CHECK(rc::check([] {
    const Surd a = some(*radicand());
    RC_ASSERT(a.sign() == sign(valued(a)));
    RC_ASSERT(valued(a.floor()) == floor(valued(a)));
  }));
}

TEST_CASE("surds compare as their values do, also over different roots") {
  CHECK(rc::check([] {
    const Surd a = some(*radicand()), b = some(*radicand());
    const Real difference = valued(a) - valued(b);
    // Two different surds of this size differ by far more than 10^-150.
    const int expected = abs(difference) < Real("1e-150") ? 0 : sign(difference);
    RC_ASSERT((a <=> b) == (expected <=> 0));
    RC_ASSERT((b <=> a) == (0 <=> expected));
    RC_ASSERT((a == b) == (expected == 0));
  }));
  CHECK(Surd::sqrt(2) < Surd::sqrt(3));
  CHECK(-Surd::sqrt(3) < -Surd::sqrt(2));
  CHECK(Surd(3) - Surd::sqrt(2) > Surd::sqrt(2));
  CHECK(Surd(1, 1, 2) != Surd(1, 1, 3));
  CHECK(Surd(Rational::parse("0.31783724519578224472575761729"), 1, 2) < Surd::sqrt(3));
  CHECK(Surd(Rational::parse("0.31783724519578224472575761730"), 1, 2) > Surd::sqrt(3));
}

TEST_CASE("a difference that cancels a hundred digits still has its sign") {
  CHECK(rc::check([] {
    const Rational d = *rc::gen::map(random::whole(2, 1000), [](int i) { return Rational(i * i + 1); });
    const Surd root = Surd::sqrt(d);
    const int places = *random::whole(10, 100);
    const Rational below = (root * Rational(10).pow(places)).floor() / Rational(10).pow(places);
    const Surd gap = root - below;
    RC_ASSERT(gap.sign() == 1);
    RC_ASSERT((gap - Rational(10).pow(-places)).sign() == -1);
    RC_ASSERT(gap.floor() == 0);
    RC_ASSERT((-gap).floor() == -1);
    const Real value = valued(root, 300) - valued(below, 300);
    RC_ASSERT(gap.to_double() == value.convert_to<double>());
    RC_ASSERT(abs(valued(Rational::parse(gap.significant(20)), 300) / value - 1) < Real("5.0001e-20"));
  }));
}

TEST_CASE("surds round to binary64 and binary32 as MPFR rounds 200 digits") {
  CHECK(rc::check([] {
    const Surd a = some(*radicand());
    const Real value = valued(a);
    RC_ASSERT(a.to_double() == mpfr_get_d(value.backend().data(), MPFR_RNDN));
    RC_ASSERT(a.to_float() == mpfr_get_flt(value.backend().data(), MPFR_RNDN));
  }));
  const Surd tiny = Surd::sqrt(2) * Rational(10).pow(-400);
  CHECK(tiny.to_double() == 0);
  CHECK_FALSE(std::signbit(tiny.to_double()));
  CHECK(std::signbit((-tiny).to_double()));
  CHECK((Surd::sqrt(2) * Rational(10).pow(400)).to_double() == std::numeric_limits<double>::infinity());
  CHECK((Surd::sqrt(2) * Rational(2).pow(-1075)).to_double() == 5e-324);
  CHECK((Surd::sqrt(2) * Rational(2).pow(-1076)).to_double() == 0);
}

TEST_CASE("decimals of surds are those of their values to 200 digits") {
  CHECK(rc::check([] {
    const Surd a = some(*radicand());
    const int places = *random::whole(0, 40);
    const Real slack("1e-150");  // for rational ties, which 200 digits in binary do not hold
    RC_ASSERT(abs(valued(Rational::parse(a.decimal(places))) - valued(a)) <=
              valued(Rational(1, 2) * Rational(10).pow(-places)) + slack);
    if (a.is_zero()) return;
    const int digits = *random::whole(1, 40);
    const Real error = abs(valued(Rational::parse(a.significant(digits))) / valued(a) - 1);
    RC_ASSERT(error <= valued(Rational(1, 2) * Rational(10).pow(1 - digits)) + slack);
  }));
  // The OEIS, A002193 and A002163.
  CHECK(Surd::sqrt(2).decimal(50) == "1.41421356237309504880168872420969807856967187537695");
  CHECK(Surd::sqrt(5).significant(41) == "2.2360679774997896964091736687312762354406");
  CHECK((-Surd::sqrt(2)).decimal(3) == "-1.414");
  CHECK((Surd::sqrt(2) / 1000).decimal(2) == "0.00");
  CHECK(Surd::sqrt(Rational::parse("1e-20") * 2).significant(3) == "1.41e-10");
  CHECK(Surd::sqrt(99).significant(1) == "10");
  CHECK(Surd::sqrt(Rational(9999, 10000)).significant(2) == "1.0");
  CHECK(Surd::sqrt(Rational(1) / 10).significant(3) == "0.316");
}

TEST_CASE("an approximation is as close as it says") {
  CHECK(rc::check([] {
    const Surd a = some(*radicand());
    const int digits = *random::whole(0, 100);
    const Rational near = a.approximation(digits);
    if (a.is_zero())
      RC_ASSERT(near.is_zero());
    else
      RC_ASSERT((Surd(near) - a).abs() <= a.abs() * Rational(10).pow(-digits));
  }));
}

TEST_CASE("radicands that differ by a square are the same root") {
  CHECK(Surd::sqrt(8) == 2 * Surd::sqrt(2));
  CHECK((Surd::sqrt(8) - 2 * Surd::sqrt(2)).is_rational());
  CHECK(Surd::sqrt(Rational(1, 2)) * Surd::sqrt(2) == 1);
  CHECK(Surd::sqrt(12) + Surd::sqrt(27) == 5 * Surd::sqrt(3));
  CHECK(Surd(1, 1, 8) / Surd(1, 2, 2) == 1);
}

TEST_CASE("roots that have nothing to do with each other are refused, negative ones undefined") {
  CHECK_THROWS_AS(Surd::sqrt(2) + Surd::sqrt(3), Unable);
  CHECK_THROWS_AS(Surd::sqrt(2) * Surd::sqrt(3), Unable);
  CHECK_THROWS_AS(Surd::sqrt(-1), Undefined);
  CHECK_THROWS_AS(Surd::sqrt(2) / 0, Undefined);
}

TEST_CASE("a surd prints its two parts") {
  CHECK(Surd(Rational(1, 2), Rational(3, 4), 5).str() == "1/2 + 3/4*sqrt(5)");
  CHECK(Surd(Rational(1, 2), -1, 5).str() == "1/2 - sqrt(5)");
  CHECK(Surd(0, -2, 5).str() == "-2*sqrt(5)");
  CHECK(Surd::sqrt(Rational(9, 4)).str() == "3/2");
  CHECK(Surd(1, 1, 4).is_rational());
  CHECK(Surd(1, 0, 5).radicand() == 0);
}

TEST_CASE("a surd may be combined with itself") {
  Surd s(1, 1, 2);
  s += *&s;
  CHECK(s == Surd(2, 2, 2));
  s *= *&s;
  CHECK(s == Surd(12, 8, 2));
  s /= *&s;
  CHECK(s == 1);
  s -= *&s;
  CHECK(s.is_zero());
}
