// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

std::string refusal(const std::string& text) {
  try {
    Rational::parse(text);
  } catch (const BadInput& e) {
    return e.what();
  }
  return "accepted";
}

std::string printed(const char* format, int digits, double value) {
  char buffer[800];
  std::snprintf(buffer, sizeof buffer, format, digits, value);
  return buffer;
}

}  // namespace

TEST_CASE("a number is read exactly") {
  CHECK(Rational::parse("3") == 3);
  CHECK(Rational::parse("-1/50") == Rational(-1, 50));
  CHECK(Rational::parse("0.02") == Rational(1, 50));
  CHECK(Rational::parse("+1.5e-3") == Rational(3, 2000));
  CHECK(Rational::parse(".5") == Rational(1, 2));
  CHECK(Rational::parse("1e6") == 1'000'000);
  CHECK(Rational::parse("1E+2") == 100);
  CHECK(Rational::parse("-0") == 0);
  CHECK(Rational::parse("007") == 7);
  CHECK(Rational::parse("0e999999999") == 0);
  CHECK(Rational::parse("100.00e-2") == 1);
  CHECK(Rational::parse("4/6") == Rational(2, 3));
}

TEST_CASE("what a rational prints is read back as the same rational") {
  CHECK(rc::check([](const Rational& a) { RC_ASSERT(Rational::parse(a.str()) == a); }));
}

TEST_CASE("a text that is no number is refused in a sentence that quotes it") {
  for (const char* text :
       {"1/3.", "--1", "0x10", "nan",   "inf",   "1.",  "e5",    "1e",    "1e+", "-",     "+",  ".",
        "/2",   "1/",  "1/-3", "1.5/2", "1e3/2", "1,5", "1_000", "1/2/3", "½",   "1e5.0", "1d", "+-1"}) {
    CAPTURE(text);
    CHECK(refusal(text) ==
          "\"" + std::string(text) + "\" is not a number; a number looks like 3, -1/50, 0.02 or 1.5e-3");
  }
  CHECK(refusal("") == "an empty text is not a number");
  CHECK(refusal("1 2") == "\"1 2\" is not a number: there is a space in it");
  CHECK(refusal(" 1") == "\" 1\" is not a number: there is a space in it");
  CHECK(refusal("1/0") == "\"1/0\" is a division by zero");
  CHECK(refusal("0/00") == "\"0/00\" is a division by zero");
  CHECK(refusal(std::string("1\0002", 3)).find("\"1?2\"") == 0);
  CHECK(refusal(std::string(60, 'x')).find("\"" + std::string(40, 'x') + "...\"") == 0);
}

TEST_CASE("a number of more than 10,000 digits is refused, without building it") {
  const std::string refused = " has more than 10,000 digits, which is our limit";
  for (const char* text : {"1e999999999", "1e-999999999", "1e99999999999999999999999999", "1e10000",
                           "1e-10000", "0.1e-9999", "123e9998"}) {
    CAPTURE(text);
    CHECK(refusal(text) == "\"" + std::string(text) + "\"" + refused);
  }
  CHECK(refusal(std::string(10'001, '9')).ends_with(refused));
  CHECK(refusal(std::string(8'000'000, '9')).ends_with(refused));
  CHECK(refusal("1/" + std::string(10'001, '9')).ends_with(refused));
  CHECK(Rational::parse(std::string(10'000, '9')).digits() == 10'000);
  CHECK(Rational::parse("1e9999").digits() == 10'000);
  CHECK(Rational::parse("1e-9999").digits() == 10'000);
  // 1/2^10000: ten thousand places, but no more than 3,011 digits once the fives have gone.
  const Rational tiny = Rational(1, 2).pow(10'000);
  CHECK(Rational::parse(tiny.decimal(10'000)) == tiny);
}

TEST_CASE("a decimal is rounded to nearest, ties away from zero") {
  CHECK(Rational(-11, 400).decimal(4) == "-0.0275");
  CHECK(Rational(1, 3).decimal(5) == "0.33333");
  CHECK(Rational(2, 3).decimal(5) == "0.66667");
  CHECK(Rational(1, 2).decimal(0) == "1");
  CHECK(Rational(-1, 2).decimal(0) == "-1");
  CHECK(Rational(5, 2).decimal(0) == "3");
  CHECK(Rational(1, 8).decimal(2) == "0.13");
  CHECK(Rational(-1, 1000).decimal(2) == "0.00");
  CHECK(Rational(999, 1000).decimal(2) == "1.00");
  CHECK(Rational(12).decimal(3) == "12.000");
  CHECK(Rational(0).decimal(2) == "0.00");
  CHECK_THROWS_AS(Rational(1).decimal(-1), Error);
}

TEST_CASE("decimals are the closest ones of their length") {
  CHECK(rc::check([](const Rational& a) {
    const int places = *random::whole(0, 60);
    const Rational shown = Rational::parse(a.decimal(places));
    RC_ASSERT((shown - a).abs() * 2 <= Rational(10).pow(-places));
    if ((shown - a).abs() * 2 == Rational(10).pow(-places)) RC_ASSERT(shown.abs() > a.abs());
  }));
}

TEST_CASE("decimals of binary64 numbers are those of the C library, which rounds correctly too") {
  CHECK(rc::check([] {
    const auto bits = *random::whole<std::int64_t>((std::int64_t{1} << 52) + 1, std::int64_t{1} << 53);
    const double value = std::ldexp(static_cast<double>(bits | 1), *random::whole(-120, 40));
    const int digits = *random::whole(1, 17);
    const Rational exact = Rational::from_double(value);
    // Of two texts that are equally close the C library takes the even one, we the larger.
    const auto agree = [&](const std::string& ours, const std::string& theirs) {
      return ours == theirs || exact - Rational::parse(theirs) == Rational::parse(ours) - exact;
    };
    if (value < 1e12) RC_ASSERT(agree(exact.decimal(digits), printed("%.*f", digits, value)));
    const std::string shown = exact.significant(digits);
    const std::string expected = printed("%.*e", digits - 1, value);
    if (value < 1e-7 || value > 1e16)
      RC_ASSERT(agree(shown, expected));
    else
      RC_ASSERT((Rational::parse(shown) - exact).abs() == (Rational::parse(expected) - exact).abs());
  }));
}

TEST_CASE("significant digits keep their zeros and change to powers of ten outside [1e-6, 1e15)") {
  CHECK(Rational(0).significant(3) == "0");
  CHECK(Rational(1, 2).significant(3) == "0.500");
  CHECK(Rational(123456).significant(3) == "123000");
  CHECK(Rational::parse("1.25e-9").significant(3) == "1.25e-09");
  CHECK(Rational::parse("1e-6").significant(2) == "0.0000010");
  CHECK(Rational::parse("9.99e-7").significant(3) == "9.99e-07");
  CHECK(Rational::parse("9.999e-7").significant(3) == "0.00000100");
  CHECK(Rational::parse("1e15").significant(1) == "1e+15");
  CHECK(Rational::parse("999999999999999").significant(15) == "999999999999999");
  CHECK(Rational::parse("999999999999999").significant(3) == "1.00e+15");
  CHECK(Rational::parse("-1e-400").significant(2) == "-1.0e-400");
  CHECK(Rational(995, 1000).significant(2) == "1.0");
  CHECK_THROWS_AS(Rational(1).significant(0), Error);
}

TEST_CASE("the digits of a number are those of its larger half") {
  CHECK(Rational(0).digits() == 1);
  CHECK(Rational(-9).digits() == 1);
  CHECK(Rational(10).digits() == 2);
  CHECK(Rational(1, 100).digits() == 3);
  for (int n : {1, 17, 18, 19, 20, 100, 1000}) {
    CAPTURE(n);
    CHECK(Rational(10).pow(n).digits() == static_cast<std::size_t>(n + 1));
    CHECK((Rational(10).pow(n) - 1).digits() == static_cast<std::size_t>(n));
  }
}
