// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/word_series.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "tests/algebra/random_lie.hpp"

using namespace shortfall;
using Element = LieElement<Rational>;

namespace {

/// [letters[0], [letters[1], ... [.., last]]].
Element nested(int degree, std::string_view letters) {
  const auto letter = [&](char c) { return c == 'A' ? Element::a(degree) : Element::b(degree); };
  Element result = letter(letters.back());
  for (std::size_t k = letters.size() - 1; k-- > 0;) result = bracket(letter(letters[k]), result);
  return result;
}

using RationalMatrix = std::vector<std::vector<Rational>>;

RationalMatrix product(const RationalMatrix& x, const RationalMatrix& y) {
  RationalMatrix result(x.size(), std::vector<Rational>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!x[i][k].is_zero())
        for (std::size_t j = 0; j < x.size(); ++j) result[i][j] += x[i][k] * y[k][j];
  return result;
}

RationalMatrix plus(RationalMatrix x, const Rational& factor, const RationalMatrix& y) {
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) x[i][j] += factor * y[i][j];
  return x;
}

RationalMatrix unit(std::size_t n) {
  RationalMatrix result(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i) result[i][i] = 1;
  return result;
}

/// Of a matrix whose powers end.
RationalMatrix exponential(const RationalMatrix& x) {
  RationalMatrix result = unit(x.size()), term = result;
  for (int k = 1; k < static_cast<int>(x.size()); ++k) {
    term = product(term, x);
    result = plus(result, Rational(1) / factorial(k), term);
  }
  return result;
}

RationalMatrix logarithm(const RationalMatrix& x) {
  const RationalMatrix rest = plus(x, -1, unit(x.size()));
  RationalMatrix result(x.size(), std::vector<Rational>(x.size())), power = unit(x.size());
  for (int k = 1; k < static_cast<int>(x.size()); ++k) {
    power = product(power, rest);
    result = plus(result, Rational(k % 2 == 1 ? 1 : -1, k), power);
  }
  return result;
}

RationalMatrix value(const Element& x, int d, int index, const RationalMatrix& a, const RationalMatrix& b) {
  if (d == 1) return index == 0 ? a : b;
  const auto [left, right] = x.basis().factors(d, index);
  const RationalMatrix u = value(x, left.first, left.second, a, b),
                       v = value(x, right.first, right.second, a, b);
  return plus(product(u, v), -1, product(v, u));
}

RationalMatrix strictly_upper(std::size_t n) {
  RationalMatrix result(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) result[i][j] = *random::small_rational();
  return result;
}

}  // namespace

TEST_CASE("the series of Baker, Campbell and Hausdorff has its published coefficients to degree 6") {
  // Rossmann (2002), Lie Groups, 1.3, and the usual list of the terms of degrees 5 and 6, in nested brackets.
  const int n = 6;
  const auto term = [](const Rational& c, std::string_view letters) { return c * nested(n, letters); };
  Element known = Element::a(n) + Element::b(n) + term(Rational(1, 2), "AB");
  known += term(Rational(1, 12), "AAB") + term(Rational(1, 12), "BBA") - term(Rational(1, 24), "BAAB");
  known -= term(Rational(1, 720), "BBBBA") + term(Rational(1, 720), "AAAAB");
  known += term(Rational(1, 360), "ABBBA") + term(Rational(1, 360), "BAAAB");
  known += term(Rational(1, 120), "BABAB") + term(Rational(1, 120), "ABABA");
  known += term(Rational(1, 240), "ABABAB") + term(Rational(1, 720), "ABAAAB") -
           term(Rational(1, 720), "AABBAB") + term(Rational(1, 1440), "ABBBAB") -
           term(Rational(1, 1440), "AABAAB");
  CHECK(bch(Element::a(n), Element::b(n)) == known);
}

TEST_CASE("[A,[A,...[A,B]]] has a Bernoulli number over a factorial as its coefficient, to degree 12") {
  const Element z = bch(Element::a(12), Element::b(12));
  const std::vector<Rational> bernoulli{1,
                                        Rational(1, 2),
                                        Rational(1, 6),
                                        0,
                                        Rational(-1, 30),
                                        0,
                                        Rational(1, 42),
                                        0,
                                        Rational(-1, 30),
                                        0,
                                        Rational(5, 66),
                                        0};
  for (int k = 1; k <= 11; ++k)
    CHECK(z.at(k + 1, 0) == bernoulli[static_cast<std::size_t>(k)] / factorial(k));
}

TEST_CASE("for nilpotent matrices the series gives the logarithm of the product") {
  CHECK(rc::check([] {
    constexpr std::size_t kSize = 6;  // brackets of six factors vanish
    const RationalMatrix a = strictly_upper(kSize), b = strictly_upper(kSize);
    const Element z = bch(Element::a(5), Element::b(5));
    RationalMatrix sum(kSize, std::vector<Rational>(kSize));
    for (int d = 1; d <= 5; ++d)
      for (int i = 0; i < z.basis().dimension(d); ++i)
        if (!z.at(d, i).is_zero()) sum = plus(sum, z.at(d, i), value(z, d, i, a, b));
    RC_ASSERT(sum == logarithm(product(exponential(a), exponential(b))));
  }));
}

TEST_CASE("the logarithm undoes the exponential, and exp(-x) is its inverse") {
  CHECK(rc::check([] {
    const Element x = *random::lie_element(6);
    RC_ASSERT(log(exp(x)) == x);
    RC_ASSERT(exp(x) * exp(-x) == WordSeries<Rational>(6));
  }));
}

TEST_CASE("log(exp x exp y) is associative, and exp(c) exp(x) exp(-c) = exp(exp(ad c) x)") {
  CHECK(rc::check([] {
    const Element x = *random::lie_element(4), y = *random::lie_element(4), z = *random::lie_element(4);
    RC_ASSERT(bch(bch(x, y), z) == bch(x, bch(y, z)));
    RC_ASSERT(bch(bch(x, y), -x) == exp_ad(x, y));
  }));
}

TEST_CASE("multiplying by exp(c A) or exp(c B) is multiplying by the series") {
  CHECK(rc::check([] {
    const Element x = *random::lie_element(5);
    const Rational c = *random::small_rational();
    for (const bool b : {false, true}) {
      WordSeries<Rational> product = exp(x);
      product.multiply_by_exponential(b, c);
      RC_ASSERT(product == exp(x) * exp(c * (b ? Element::b(5) : Element::a(5))));
    }
  }));
}

TEST_CASE("the logarithm of a palindrome has odd degrees only, to degree 12") {
  WordSeries<Rational> step(12);
  for (const auto& [b, c] : {std::pair{true, Rational(1, 6)},
                             {false, Rational(1, 2)},
                             {true, Rational(2, 3)},
                             {false, Rational(1, 2)},
                             {true, Rational(1, 6)}})
    step.multiply_by_exponential(b, c);
  const Element z = log(step);
  for (int d = 2; d <= 12; d += 2) CHECK(Element::homogeneous(12, d, z.part(d)).is_zero());
  CHECK_FALSE(Element::homogeneous(12, 11, z.part(11)).is_zero());
}
