// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/fraction.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

const Fraction h = Fraction::letter(0);
const Fraction n = Fraction::letter(1);

bool is_canonical(const Fraction& f) {
  if (f.is_zero()) return f.denominator() == Polynomial(1);
  return f.denominator().terms().front().coefficient.is_one() &&
         gcd(f.numerator(), f.denominator()) == Polynomial(1);
}

}  // namespace

TEST_CASE("fractions obey the laws of a field") {
  CHECK(rc::check([](const Fraction& a, const Fraction& b, const Fraction& c) {
    RC_ASSERT(a + b == b + a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    RC_ASSERT(a - b == a + -b);
    if (!a.is_zero()) RC_ASSERT(a / a == Fraction(1));
    if (!a.is_zero()) RC_ASSERT(b / a * a == b);
  }));
}

TEST_CASE("fractions stay in lowest terms with a monic denominator") {
  CHECK(rc::check([](const Fraction& a, const Fraction& b) {
    RC_ASSERT(is_canonical(a));
    RC_ASSERT(is_canonical(a + b));
    RC_ASSERT(is_canonical(a - b));
    RC_ASSERT(is_canonical(a * b));
    RC_ASSERT(is_canonical(a.pow(2)));
    if (a.is_zero()) return;
    RC_ASSERT(is_canonical(b / a));
    RC_ASSERT(is_canonical(a.pow(-2)));
    // The same denominator on both sides takes a way of its own.
    RC_ASSERT(
        is_canonical(Fraction(b.numerator(), a.numerator()) + Fraction(b.denominator(), a.numerator())));
  }));
}

TEST_CASE("fractions compute as the numbers do that they stand for") {
  CHECK(rc::check([](const Fraction& a, const Fraction& b) {
    const std::map<Letter, Rational> at{
        {0, *random::small_rational()}, {3, Rational(5, 7)}, {15, Rational(-11, 13)}};
    Rational s, t;
    try {
      s = a.evaluate(at);
      t = b.evaluate(at);
    } catch (const Undefined&) {
      RC_DISCARD("a denominator vanishes");
    }
    RC_ASSERT((a + b).evaluate(at) == s + t);
    RC_ASSERT((a - b).evaluate(at) == s - t);
    RC_ASSERT((a * b).evaluate(at) == s * t);
    if (!t.is_zero()) RC_ASSERT((a / b).evaluate(at) == s / t);
  }));
}

TEST_CASE("a fraction may be put in place of a letter") {
  CHECK(rc::check([](const Fraction& a, const Fraction& b) {
    const std::map<Letter, Rational> at{
        {0, *random::small_rational()}, {3, Rational(5, 7)}, {15, Rational(-11, 13)}};
    Rational expected;
    Fraction moved;
    try {
      std::map<Letter, Rational> there = at;
      there[3] = b.evaluate(at);
      expected = a.evaluate(there);
      moved = a.substitute(3, b);
    } catch (const Undefined&) {
      RC_DISCARD("a denominator vanishes");
    }
    RC_ASSERT(is_canonical(moved));
    RC_ASSERT(moved.evaluate(at) == expected);
  }));
  CHECK((1 / (h + 1)).substitute(0, 1 / n) == n / (n + 1));
  CHECK((h * h / (h + 1)).substitute(0, 1 / n) == 1 / (n * (n + 1)));
  CHECK_THROWS_AS((1 / (h - n)).substitute(0, n), Undefined);
  CHECK_THROWS_AS((1 / (h * n - 1)).substitute(0, 1 / n), Undefined);
}

TEST_CASE("uncancelled factors cancel") {
  CHECK((h * h - n * n) / (h - n) == h + n);
  CHECK(1 / (h - n) + 1 / (h + n) == 2 * h / (h * h - n * n));
  CHECK(1 / (h - n) - 1 / (h - n) == Fraction());
  CHECK((h + n) / (h - n) + 2 * n / (n - h) == Fraction(1));
  CHECK(h * n / (h * h) == n / h);
}

TEST_CASE("a fraction may be combined with itself") {
  Fraction f = h / (h + 1);
  f += *&f;
  CHECK(f == 2 * h / (h + 1));
  f *= *&f;
  CHECK(f == (2 * h / (h + 1)).pow(2));
  f /= *&f;
  CHECK(f == Fraction(1));
  f -= *&f;
  CHECK(f.is_zero());
}

TEST_CASE("negative powers are powers of the inverse") {
  CHECK(Fraction::letter(0, -3) * h.pow(3) == Fraction(1));
  CHECK((2 * h / n).pow(-2) == n * n / (4 * h * h));
  CHECK((h / n).pow(0) == Fraction(1));
  CHECK_THROWS_AS(Fraction().pow(-1), Undefined);
}

TEST_CASE("division by zero is undefined") {
  CHECK_THROWS_AS(h / Fraction(), Undefined);
  CHECK_THROWS_AS(Fraction(Polynomial(1), Polynomial()), Undefined);
  CHECK_THROWS_AS((1 / h).evaluate({{0, 0}}), Undefined);
  CHECK_THROWS_AS((1 / h).evaluate({}), Error);
}

TEST_CASE("a fraction prints as a quotient that reads unambiguously") {
  const std::vector<std::string> names{"h", "n"};
  CHECK(((h + 1) / (h - 1)).str(names) == "(h + 1)/(h - 1)");
  CHECK((n / h.pow(2)).str(names) == "n/h^2");
  CHECK((1 / (h * n)).str(names) == "1/(h*n)");
  CHECK((-h / (2 * n + 4)).str(names) == "-1/2*h/(n + 2)");
  CHECK((h / 2).str(names) == "1/2*h");
  CHECK(Fraction().str(names) == "0");
}

TEST_CASE("a fraction knows whether it is a polynomial, and which letters it has") {
  CHECK((h * n / n).is_polynomial());
  CHECK_FALSE((h / n).is_polynomial());
  CHECK((h / n).contains(1));
  CHECK_FALSE((h / n).contains(2));
  CHECK((h / h / 3).is_constant());
  CHECK((h / h / 3).constant() == Rational(1, 3));
}
