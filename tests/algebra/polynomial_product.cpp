// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <array>
#include <map>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

using Exponents = std::array<int, kLetters>;

/// The product by the schoolbook, with a map instead of packed keys and rationals instead of integers.
std::map<Exponents, Rational> schoolbook(const Polynomial& a, const Polynomial& b) {
  std::map<Exponents, Rational> sums;
  for (const auto& s : a.terms())
    for (const auto& t : b.terms()) {
      Exponents e;
      for (Letter letter = 0; letter < kLetters; ++letter)
        e[static_cast<std::size_t>(letter)] = s.monomial.exponent(letter) + t.monomial.exponent(letter);
      sums[e] += s.coefficient * t.coefficient;
    }
  std::erase_if(sums, [](const auto& entry) { return entry.second.is_zero(); });
  return sums;
}

std::map<Exponents, Rational> as_map(const Polynomial& p) {
  std::map<Exponents, Rational> sums;
  for (const auto& t : p.terms()) {
    Exponents e;
    for (Letter letter = 0; letter < kLetters; ++letter)
      e[static_cast<std::size_t>(letter)] = t.monomial.exponent(letter);
    sums[e] = t.coefficient;
  }
  return sums;
}

/// Some terms in all sixteen letters with exponents up to `most` and any coefficients.
rc::Gen<Polynomial> wide(int most) {
  const auto term =
      rc::gen::map(rc::gen::pair(rc::gen::container<std::vector<int>>(kLetters, random::whole(0, most + 1)),
                                 rc::gen::arbitrary<Rational>()),
                   [](const std::pair<std::vector<int>, Rational>& p) {
                     Monomial m;
                     for (Letter letter = 0; letter < kLetters; ++letter)
                       m = m.with(letter, p.first[static_cast<std::size_t>(letter)]);
                     return Polynomial::Term{m, p.second};
                   });
  return rc::gen::map(random::list<Polynomial::Term>(6, term), [](std::vector<Polynomial::Term> terms) {
    return Polynomial::from_terms(std::move(terms));
  });
}

}  // namespace

TEST_CASE("a product is the schoolbook's product: small coefficients, three letters") {
  CHECK(rc::check(
      [](const Polynomial& a, const Polynomial& b) { RC_ASSERT(as_map(a * b) == schoolbook(a, b)); }));
}

TEST_CASE(
    "a product is the schoolbook's product: sixteen letters, exponents that fit no word, coefficients of any "
    "size") {
  CHECK(rc::check([] {
    const int most = *rc::gen::element(1, 2, 3000, 32767);
    const Polynomial a = *wide(most);
    const Polynomial b = *wide(most);
    RC_ASSERT(as_map(a * b) == schoolbook(a, b));
  }));
}

TEST_CASE("products stay exact where sums of 128 bits would wrap") {
  const Rational big = Rational::parse("9223372036854775807");
  Polynomial a;
  for (int k = 0; k < 64; ++k) a += Polynomial::letter(0, k) * big;
  CHECK(as_map(a * a) == schoolbook(a, a));
  CHECK(as_map(a * -a) == schoolbook(a, -a));
  const Rational least = Rational::parse("-9223372036854775808");
  const Polynomial b = Polynomial::letter(0) * least + least;
  CHECK(as_map(b * b) == schoolbook(b, b));
}

TEST_CASE("denominators whose common multiple overflows a word are no obstacle") {
  Polynomial a;
  int k = 0;
  for (int prime : {1009, 1013, 1019, 1021, 1031, 1033, 1039, 1049})
    a += Polynomial::letter(1, k++) * Rational(1, prime);
  CHECK(as_map(a * a) == schoolbook(a, a));
}

TEST_CASE("the binomial theorem holds for the fiftieth power") {
  const Polynomial power = (Polynomial::letter(2) + Polynomial::letter(5) * Rational(1, 2)).pow(50);
  CHECK(power.terms().size() == 51);
  for (int k = 0; k <= 50; ++k)
    CHECK(power.coefficient(5, k) ==
          Polynomial::letter(2, 50 - k) * (binomial(50, k) * Rational(1, 2).pow(k)));
}

TEST_CASE("many terms: the square of a sum of all letters' multinomials") {
  Polynomial sum = 1;
  for (Letter letter = 0; letter < 8; ++letter) sum += Polynomial::letter(letter);
  const Polynomial fourth = sum.pow(4);
  CHECK(fourth.terms().size() == 495);  // 12 choose 4
  CHECK(as_map(fourth * fourth) == as_map(sum.pow(8)));
  Rational total;
  for (const auto& term : sum.pow(8).terms()) total += term.coefficient;
  CHECK(total == Rational(9).pow(8));
}
