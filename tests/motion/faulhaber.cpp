// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/faulhaber.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"

using namespace shortfall;

TEST_CASE("the sums of powers are what adding up gives, to degree 50") {
  const auto sums = power_sums(50);
  for (int m = 0; m <= 50; ++m) {
    Rational total;
    for (int n = 0; n <= 60; ++n) {
      Rational value;
      for (int j = m + 1; j >= 0; --j) value = value * n + sums[m][j];
      CHECK(value == total);
      total += m == 0 ? Rational(1) : Rational(n).pow(m);
    }
  }
}

TEST_CASE("Bernoulli's numbers satisfy their own recurrence") {
  const std::vector<Rational> b = bernoulli_numbers(60);
  REQUIRE(b.size() == 61);
  for (int m = 1; m <= 60; ++m) {  // sum of C(m+1, k) B_k over k = 0 .. m is 0
    Rational sum;
    for (int k = 0; k <= m; ++k) sum += binomial(m + 1, k) * b[k];
    CHECK(sum.is_zero());
  }
  CHECK(bernoulli_numbers(0) == std::vector<Rational>{1});
  CHECK(bernoulli_numbers(3) == std::vector<Rational>{1, Rational(-1, 2), Rational(1, 6), 0});
}

TEST_CASE("the coefficients of n are Bernoulli's numbers") {
  const auto sums = power_sums(50);
  CHECK(sums[1][1] == Rational(-1, 2));
  CHECK(sums[2][1] == Rational(1, 6));
  CHECK(sums[12][1] == Rational(-691, 2730));
  CHECK(sums[50][1].str() == "495057205241079648212477525/66");
}

TEST_CASE("a sum over k of a polynomial in k and letters") {
  const Fraction n = Fraction::letter(kCount);
  const Fraction h = Fraction::letter(kStepLetter);
  // Gauss: h (0 + 1 + ... + (n-1)) + n/(1+h)
  const Fraction p = h * n + Fraction(1) / (Fraction(1) + h);
  CHECK(indefinite_sum(p, kCount) == h * n * (n - Fraction(1)) / Fraction(2) + n / (Fraction(1) + h));
  CHECK_THROWS_AS(indefinite_sum(Fraction(1) / n, kCount), Undefined);
}
