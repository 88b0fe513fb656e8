// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

const Polynomial x = Polynomial::letter(0);
const Polynomial y = Polynomial::letter(3);
const Polynomial z = Polynomial::letter(15);

bool is_monic(const Polynomial& p) { return p.terms().front().coefficient.is_one(); }

rc::Gen<Polynomial> nonzero() { return random::nonzero_polynomial(4, 3); }

}  // namespace

TEST_CASE("a common factor is found, whatever it is multiplied with") {
  CHECK(rc::check([] {
    const Polynomial g = *nonzero(), a = *nonzero(), b = *nonzero();
    const Polynomial found = gcd(g * a, g * b);
    Polynomial quotient;
    RC_ASSERT(is_monic(found));
    RC_ASSERT(divides(g, found, &quotient));
    RC_ASSERT(divides(found, g * a, &quotient));
    RC_ASSERT(quotient * found == g * a);
    const Polynomial other = exact_quotient(g * b, found);
    RC_ASSERT(gcd(quotient, other) == 1);
    RC_ASSERT(gcd(g * b, g * a) == found);
    Polynomial a_rest, b_rest;
    RC_ASSERT(gcd(g * a, g * b, &a_rest, &b_rest) == found);
    RC_ASSERT(a_rest == quotient);
    RC_ASSERT(b_rest == other);
  }));
}

TEST_CASE("the greatest common divisor is monic and known in simple cases") {
  CHECK(gcd(Polynomial(), Polynomial()).is_zero());
  CHECK(gcd(Polynomial(), 3 * x - 6) == x - 2);
  CHECK(gcd(3 * x - 6, Polynomial()) == x - 2);
  CHECK(gcd(Polynomial(6), Polynomial(4)) == 1);
  CHECK(gcd(2 * x, Polynomial(4)) == 1);
  CHECK(gcd(x + 1, y + 1) == 1);
  CHECK(gcd(2 * x.pow(3) * y, x.pow(2) * y.pow(5) * z) == x.pow(2) * y);
  CHECK(gcd(2 * x.pow(3) * y, x.pow(2) + x * z) == x);
  CHECK(gcd(x.pow(2) - y.pow(2), x.pow(2) + 2 * x * y + y.pow(2)) == x + y);
  CHECK(gcd((x * y - 1) * Rational(2, 3), (x * y - 1) * Rational(1, 7)) == x * y - 1);
  CHECK(gcd(2 * x - 4, 2 * x - 4) == x - 2);
  CHECK(gcd(x.pow(12) - 1, x.pow(18) - 1) == x.pow(6) - 1);
}

TEST_CASE("with the greatest common divisor come the quotients, in the simple cases too") {
  const auto rests = [](const Polynomial& a, const Polynomial& b) {
    Polynomial a_rest, b_rest;
    const Polynomial common = gcd(a, b, &a_rest, &b_rest);
    return common * a_rest == a && common * b_rest == b;
  };
  CHECK(rests(Polynomial(), 3 * x - 6));
  CHECK(rests(3 * x - 6, Polynomial()));
  CHECK(rests(Polynomial(6), Polynomial(4)));
  CHECK(rests(2 * x * Rational(3, 5), Polynomial(4)));
  CHECK(rests(x + 1, y + 1));
  CHECK(rests(2 * x.pow(3) * y, x.pow(2) + x * z));
  CHECK(rests((x * y - 1) * Rational(2, 3), (x * y - 1) * Rational(-1, 7)));
  CHECK(rests(2 * x - 4, 2 * x - 4));
  CHECK(rests((x + 1) * (2 * y - 3) * Rational(5, 7), (x + 1) * (y * z + 1) * Rational(-2, 9)));
  CHECK(rests((x + 1) * Rational(5, 7), (y + x) * Rational(-2, 9)));
  Polynomial only;
  CHECK(gcd(x * x - 1, (x + 1) * y, nullptr, &only) == x + 1);
  CHECK(only == y);
}

TEST_CASE("a product is divisible by its factors and the quotient is the other one") {
  CHECK(rc::check([](const Polynomial& a) {
    const Polynomial b = *nonzero();
    RC_ASSERT(exact_quotient(a * b, b) == a);
    Polynomial quotient;
    const Polynomial above = a * b + 1;
    if (!b.is_constant()) RC_ASSERT_FALSE(divides(b, above, &quotient));
  }));
}

TEST_CASE("what does not divide is refused") {
  CHECK_THROWS_AS(exact_quotient(x, Polynomial()), Undefined);
  CHECK_THROWS_AS(exact_quotient(x * x + 1, x + 1), Undefined);
  CHECK_THROWS_AS(exact_quotient(x + y, x), Undefined);
  CHECK_THROWS_AS(exact_quotient(x, x * x), Undefined);
  CHECK_THROWS_AS(exact_quotient(x + 1, x + y), Undefined);
  CHECK(exact_quotient(Polynomial(), x).is_zero());
  CHECK(exact_quotient(x, Polynomial(2)) == x * Rational(1, 2));
  Polynomial quotient;
  CHECK_FALSE(divides(Polynomial(), x, &quotient));
  CHECK(divides(2 * x * y, 3 * x * x * y + x * y * z, &quotient));
  CHECK(quotient == Rational(3, 2) * x + Rational(1, 2) * z);
}

TEST_CASE("factors multiply to the polynomial, are monic and cannot be factored again") {
  CHECK(rc::check([] {
    const Polynomial p = *nonzero() * *nonzero() * *nonzero();
    const Factorization f = factor(p);
    Polynomial product = f.constant;
    for (const auto& [base, power] : f.factors) {
      RC_ASSERT(is_monic(base));
      RC_ASSERT_FALSE(base.is_constant());
      RC_ASSERT(power >= 1);
      const Factorization again = factor(base);
      RC_ASSERT(again.factors.size() == 1u);
      RC_ASSERT(again.factors.front().second == 1);
      RC_ASSERT(again.factors.front().first == base);
      product *= base.pow(power);
    }
    RC_ASSERT(product == p);
  }));
}

TEST_CASE("factorizations that are known from books come out, in a fixed order") {
  const Factorization germain = factor(x.pow(4) + 4 * y.pow(4));
  REQUIRE(germain.factors.size() == 2);
  CHECK(germain.constant == 1);
  CHECK(germain.factors[0].first == x.pow(2) - 2 * x * y + 2 * y.pow(2));
  CHECK(germain.factors[1].first == x.pow(2) + 2 * x * y + 2 * y.pow(2));
  CHECK(factor(x.pow(2) - 2).factors.size() == 1);
  CHECK(factor(x.pow(2) + y.pow(2)).factors.size() == 1);
  CHECK(factor(x.pow(12) - 1).factors.size() == 6);
  const Factorization f = factor(Rational(3, 4) * x * (x - y).pow(2) * (x + y));
  CHECK(f.constant == Rational(3, 4));
  REQUIRE(f.factors.size() == 3);
  CHECK(f.factors[0] == std::pair(x, 1));
  CHECK(f.factors[1] == std::pair(x - y, 2));
  CHECK(f.factors[2] == std::pair(x + y, 1));
  CHECK(factor(Polynomial(Rational(-2, 3))).constant == Rational(-2, 3));
  CHECK(factor(Polynomial(Rational(-2, 3))).factors.empty());
  CHECK(factor(Polynomial()).constant == 0);
  CHECK(factor(-5 * x.pow(3) * z).factors == std::vector{std::pair(x, 3), std::pair(z, 1)});
}
