// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/known_digits.hpp"

#include <doctest/doctest.h>

#include <string>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

TEST_CASE("a printed decimal stands for what is within a unit of its last digit") {
  const KnownDigits third = KnownDigits::printed("0.3333");
  CHECK(third.ball().contains(Rational(1, 3)));
  CHECK(third.ball().contains(Rational(3332, 10000)));
  CHECK_FALSE(third.ball().contains(Rational(3331, 10000)));
  CHECK(third.digits() == 3);
  CHECK(KnownDigits::printed("-1.25e-3").ball().contains(Rational(-125, 100000)));
  CHECK_FALSE(KnownDigits::printed("-1.25e-3").ball().contains(Rational(-127, 100000)));
  CHECK(KnownDigits::printed("12").ball().contains(13));
  CHECK_FALSE(KnownDigits::printed("12").ball().contains(14));
  CHECK_THROWS_AS(KnownDigits::printed("1/3"), BadInput);
  CHECK_THROWS_AS(KnownDigits::printed("one"), BadInput);
}

TEST_CASE("zero to the digits known is not zero") {
  const KnownDigits rest = KnownDigits(1) - KnownDigits(3) * KnownDigits::printed("0.33333333");
  CHECK(zero_as_known(rest));
  CHECK_FALSE(rest.is_zero());
  CHECK(rest.digits() == 7);
  CHECK_FALSE(zero_as_known(rest + KnownDigits(Rational(1, 1000000))));
  CHECK(zero_as_known(KnownDigits(0)));
  CHECK(KnownDigits(0).is_zero());
}

TEST_CASE("only certain digits are shown") {
  CHECK(KnownDigits(Rational(1, 3)).str() == "0." + std::string(60, '3'));
  CHECK(KnownDigits(0).str() == "0");
  const std::string text = KnownDigits::printed("0.123456").str();
  CHECK(text.size() < 9);
  CHECK(text.starts_with("0.123"));
}
