// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/polynomial.hpp"

#include <doctest/doctest.h>

#include <map>

#include "analysis/algebra/error.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

using Values = std::map<Letter, Rational>;

/// Values for the letters 0, 3, 15 that random polynomials use.
Values values(const Rational& a, const Rational& b, const Rational& c) { return {{0, a}, {3, b}, {15, c}}; }

bool is_canonical(const Polynomial& p) {
  for (std::size_t i = 0; i < p.terms().size(); ++i) {
    if (p.terms()[i].coefficient.is_zero()) return false;
    if (i > 0 && !(p.terms()[i].monomial < p.terms()[i - 1].monomial)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("monomials are ordered by degree first, then by the first letter that differs") {
  const auto of = [](int i, int j, int k) {
    return Monomial::of(0, i) * Monomial::of(4, j) * Monomial::of(15, k);
  };
  CHECK(of(0, 0, 0) < of(0, 0, 1));
  CHECK(of(0, 0, 1) < of(0, 1, 0));
  CHECK(of(0, 1, 0) < of(1, 0, 0));
  CHECK(of(1, 0, 0) < of(0, 0, 2));
  CHECK(of(1, 0, 1) < of(1, 1, 0));
  CHECK_FALSE(of(1, 1, 0) < of(1, 1, 0));
  CHECK(Monomial().is_one());
  CHECK_FALSE(of(0, 0, 1).is_one());
}

TEST_CASE("an exponent goes up to 65535 and not beyond, in every letter, and never spills into the next") {
  for (Letter letter = 0; letter < kLetters; ++letter) {
    CAPTURE(letter);
    const Monomial most = Monomial::of(letter, 65535);
    CHECK(most.exponent(letter) == 65535);
    CHECK(most.total_degree() == 65535);
    CHECK_THROWS_AS(most * Monomial::of(letter), Unable);
    CHECK_THROWS_AS(Monomial::of(letter, 40000) * Monomial::of(letter, 40000), Unable);
    CHECK_THROWS_AS(Monomial::of(letter, 65536), Unable);
    CHECK_THROWS_AS(Monomial::of(letter, 256).pow(256), Unable);
    CHECK_THROWS_AS(Monomial::of(letter, 32768).pow(131072), Unable);  // 2^32
    CHECK_THROWS_AS(Polynomial::letter(letter, 65535) * Polynomial::letter(letter), Unable);
    CHECK_THROWS_AS((Polynomial::letter(letter, 65535) + 1) * (Polynomial::letter(letter) + 1), Unable);
    for (Letter other = 0; other < kLetters; ++other)
      if (other != letter) CHECK((most * Monomial::of(other, 65535)).exponent(letter) == 65535);
  }
  Monomial all;
  for (Letter letter = 0; letter < kLetters; ++letter) all = all * Monomial::of(letter, 65535);
  CHECK(all.total_degree() == 16 * 65535);
  CHECK_THROWS_AS(Monomial::of(16), Error);
  CHECK_THROWS_AS(Monomial::of(-1), Error);
  CHECK_THROWS_AS(Monomial::of(0, -1), Error);
  CHECK_THROWS_AS(Polynomial::letter(0).degree(16), Error);
}

TEST_CASE("one monomial divides another when no exponent is larger") {
  CHECK(rc::check([] {
    Monomial a, b;
    bool expected = true;
    for (Letter letter = 0; letter < kLetters; ++letter) {
      const int i = *rc::gen::element(0, 1, 2, 32767, 32768, 65535);
      const int j = *rc::gen::oneOf(rc::gen::just(i), rc::gen::just(65535), rc::gen::element(0, 1, 32768));
      a = a.with(letter, i);
      b = b.with(letter, j);
      expected = expected && i <= j;
    }
    RC_ASSERT(a.divides(b) == expected);
    RC_ASSERT(a.divides(a));
    if (expected) RC_ASSERT(b / a * a == b);
    const Monomial common = Monomial::gcd(a, b);
    RC_ASSERT(common.divides(a));
    RC_ASSERT(common.divides(b));
    if (expected) RC_ASSERT(common == a);
  }));
}

TEST_CASE("polynomials obey the laws of a commutative ring") {
  CHECK(rc::check([](const Polynomial& a, const Polynomial& b, const Polynomial& c) {
    RC_ASSERT(a + b == b + a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT(a - b == a + -b);
    RC_ASSERT((a - a).is_zero());
    RC_ASSERT(a * 1 == a);
    RC_ASSERT((a * 0).is_zero());
  }));
}

TEST_CASE("sums and products keep the terms sorted and without zeros") {
  CHECK(rc::check([](const Polynomial& a, const Polynomial& b) {
    RC_ASSERT(is_canonical(a + b));
    RC_ASSERT(is_canonical(a - b));
    RC_ASSERT(is_canonical(a * b));
    RC_ASSERT(is_canonical((a + b) * (a - b)));
    RC_ASSERT(is_canonical(a.derivative(3)));
    RC_ASSERT(is_canonical(a.coefficient(3, 1)));
    RC_ASSERT(is_canonical(a.substitute(3, b)));
    RC_ASSERT(is_canonical(a.substitute(3, Rational(2))));
  }));
}

TEST_CASE("to evaluate is to substitute numbers: it respects sums, products and powers") {
  CHECK(rc::check([](const Polynomial& a, const Polynomial& b, const Rational& s, const Rational& t) {
    const Values at = values(s, t, Rational(-2, 3));
    RC_ASSERT((a + b).evaluate(at) == a.evaluate(at) + b.evaluate(at));
    RC_ASSERT((a - b).evaluate(at) == a.evaluate(at) - b.evaluate(at));
    RC_ASSERT((a * b).evaluate(at) == a.evaluate(at) * b.evaluate(at));
    RC_ASSERT(a.pow(3).evaluate(at) == a.evaluate(at).pow(3));
  }));
  // Few terms of high powers: nothing is made for the powers between.
  const Polynomial sparse = Polynomial::letter(0, 60000) - 3 * Polynomial::letter(0, 40000) + 5;
  CHECK(sparse.evaluate({{0, 2}}) == Rational(2).pow(60000) - 3 * Rational(2).pow(40000) + 5);
  CHECK(sparse.evaluate({{0, -1}}) == 3);
}

TEST_CASE("a polynomial may be put in place of a letter") {
  CHECK(rc::check([](const Polynomial& a, const Polynomial& b, const Rational& s) {
    const Values at = values(s, Rational(5, 7), Rational(-2, 3));
    Values moved = at;
    moved[3] = b.evaluate(at);
    RC_ASSERT(a.substitute(3, b).evaluate(at) == a.evaluate(moved));
    RC_ASSERT(a.substitute(3, Rational(5, 7)).evaluate(at) == a.evaluate(at));
    RC_ASSERT_FALSE(a.substitute(3, Rational(5, 7)).contains(3));
    RC_ASSERT(a.substitute(3, Polynomial::letter(3)) == a);
  }));
  const Polynomial h = Polynomial::letter(0), n = Polynomial::letter(1), x = Polynomial::letter(2);
  CHECK((h.pow(7) + h).substitute(0, n + 1) == (n + 1).pow(7) + n + 1);
  CHECK((h.pow(3) * n + h).substitute(0, 2 * n * x) == 8 * n.pow(4) * x.pow(3) + 2 * n * x);
  CHECK((h - n).substitute(0, n).is_zero());
}

TEST_CASE("the coefficients of a letter's powers add up to the polynomial") {
  CHECK(rc::check([](const Polynomial& a) {
    const std::vector<Polynomial> parts = a.coefficients(3);
    Polynomial sum;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      RC_ASSERT_FALSE(parts[k].contains(3));
      RC_ASSERT(parts[k] == a.coefficient(3, static_cast<int>(k)));
      sum += parts[k] * Polynomial::letter(3, static_cast<int>(k));
    }
    RC_ASSERT(sum == a);
    RC_ASSERT(static_cast<int>(parts.size()) == a.degree(3) + 1);
  }));
}

TEST_CASE("derivatives obey Leibniz's rule") {
  CHECK(rc::check([](const Polynomial& a, const Polynomial& b) {
    RC_ASSERT((a * b).derivative(3) == a.derivative(3) * b + a * b.derivative(3));
  }));
  const Polynomial h = Polynomial::letter(0);
  CHECK(h.pow(3).derivative(0) == 3 * h * h);
  CHECK(h.derivative(1).is_zero());
}

TEST_CASE("a polynomial may be combined with itself") {
  CHECK(rc::check([](const Polynomial& a) {
    Polynomial sum = a, difference = a, product = a;
    sum += *&sum;
    difference -= *&difference;
    product *= *&product;
    RC_ASSERT(sum == a * 2);
    RC_ASSERT(difference.is_zero());
    RC_ASSERT(product == a.pow(2));
    if (a.is_zero()) return;
    Polynomial scaled = a;
    scaled *= scaled.terms().front().coefficient;
    RC_ASSERT(scaled == a * Polynomial(a.terms().front().coefficient));
  }));
}

TEST_CASE("degrees and constants are read off") {
  const Polynomial h = Polynomial::letter(0), n = Polynomial::letter(1), x = Polynomial::letter(2);
  const Polynomial p = h.pow(2) * n + 3 * x + 5;
  CHECK(p.degree(0) == 2);
  CHECK(p.degree(3) == 0);
  CHECK(p.total_degree() == 3);
  CHECK(p.constant() == 5);
  CHECK((p - 5).constant() == 0);
  CHECK(p.contains(1));
  CHECK_FALSE(p.contains(3));
  CHECK_FALSE(p.is_constant());
  CHECK_FALSE(h.is_constant());
  CHECK(Polynomial(7).is_constant());
  CHECK(Polynomial().is_constant());
  CHECK(Polynomial().degree(0) == -1);
  CHECK(Polynomial().total_degree() == -1);
}

TEST_CASE("a polynomial prints with the caller's names, largest terms first") {
  const std::vector<std::string> names{"h", "n", "x"};
  const Polynomial h = Polynomial::letter(0), n = Polynomial::letter(1), x = Polynomial::letter(2);
  CHECK((Rational(1, 2) * h * h * n - 1).str(names) == "1/2*h^2*n - 1");
  CHECK((-h + n - Rational(3, 2) * x).str(names) == "-h + n - 3/2*x");
  CHECK((-h * n).str(names) == "-h*n");
  CHECK(Polynomial().str(names) == "0");
  CHECK(Polynomial(Rational(-1, 3)).str(names) == "-1/3");
  CHECK((x * x + h * x + h * h + n).str(names) == "h^2 + h*x + x^2 + n");
  CHECK_THROWS_AS(Polynomial::letter(3).str(names), Error);
}

TEST_CASE("a polynomial is made from coefficients, or from terms in any order") {
  const Polynomial h = Polynomial::letter(0);
  const std::vector<Rational> coefficients{1, 0, Rational(1, 2)};
  CHECK(Polynomial::in(0, coefficients) == Rational(1, 2) * h * h + 1);
  CHECK(Polynomial::from_terms(
            {{Monomial(), 1}, {Monomial::of(0), 2}, {Monomial(), -1}, {Monomial::of(0), 1}}) == 3 * h);
}

TEST_CASE("a letter without a value, or a negative power, is an error") {
  const Polynomial h = Polynomial::letter(0), n = Polynomial::letter(1);
  CHECK_THROWS_AS((h + n).evaluate({{0, 1}}), Error);
  CHECK_THROWS_AS((h + n).pow(-1), Error);
  CHECK(Polynomial(5).evaluate({}) == 5);
}
