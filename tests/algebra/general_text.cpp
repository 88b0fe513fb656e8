// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/general_text.hpp"

#include <doctest/doctest.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace shortfall;

TEST_CASE("doubles are printed and read as the C library does in its own locale") {
  std::mt19937_64 random(20'261'128);
  for (int i = 0; i < 20'000; ++i) {
    double value = std::ldexp(std::uniform_real_distribution<>(-1, 1)(random),
                              std::uniform_int_distribution<>(-1070, 1020)(random));
    if (i % 3 == 1) value = std::uniform_int_distribution<>(-2'000'000, 2'000'000)(random);
    if (i % 3 == 2)
      value = std::uniform_int_distribution<>(-1000, 1000)(random) *
              std::pow(10.0, std::uniform_int_distribution<>(-20, 20)(random));
    for (const int digits : {2, 6, 9, 17}) {
      char text[400];
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      REQUIRE(general_text(value, digits) == text);
      REQUIRE(double_of(text) == std::strtod(text, nullptr));
    }
    char bits[64];
    std::snprintf(bits, sizeof bits, "%a", value);
    REQUIRE(double_of(bits) == value);
  }
  CHECK(general_text(0, 5) == "0");
  CHECK(double_of("+1.5e3 m") == 1500);
  CHECK(double_of("none") == 0);
  CHECK(std::isinf(double_of("-inf")));
}

TEST_CASE("a host's decimal comma changes nothing") {
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "C.UTF-8"})
    if (std::setlocale(LC_ALL, locale)) break;
  CHECK(general_text(0.5, 9) == "0.5");
  CHECK(double_of("0.5") == 0.5);
  std::setlocale(LC_ALL, "C");
}
