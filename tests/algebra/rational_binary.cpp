// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

bool same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A finite binary64 number with any bits.
rc::Gen<double> any_double() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::pair(random::whole<std::uint64_t>(0, 2047),
                                 random::whole<std::uint64_t>(0, std::uint64_t{1} << 52)),
                   [](const std::pair<std::uint64_t, std::uint64_t>& p) {
                     return std::bit_cast<double>(p.first << 52 | p.second);
                   }),
      [](double d) { return std::isfinite(d); });
}

}  // namespace

TEST_CASE("a decimal becomes the binary number that the C library, which rounds correctly, makes of it") {
  CHECK(rc::check([] {
    const std::string digits =
        std::to_string(*random::whole<std::int64_t>(1, std::numeric_limits<std::int64_t>::max())) +
        std::to_string(*random::whole(0, 1'000'000));
    const std::string wide = digits + "e" + std::to_string(*random::whole(-350, 300));
    RC_ASSERT(same(Rational::parse(wide).to_double(), std::strtod(wide.c_str(), nullptr)));
    RC_ASSERT(same(Rational::parse("-" + wide).to_double(), -std::strtod(wide.c_str(), nullptr)));
    const std::string narrow = digits + "e" + std::to_string(*random::whole(-75, 25));
    RC_ASSERT(same(Rational::parse(narrow).to_float(), std::strtof(narrow.c_str(), nullptr)));
    const std::string few =
        std::to_string(*random::whole(1, 100'000)) + "e-" + std::to_string(*random::whole(0, 9));
    RC_ASSERT(same(Rational::parse(few).to_double(), std::strtod(few.c_str(), nullptr)));
    RC_ASSERT(same(Rational::parse(few).to_float(), std::strtof(few.c_str(), nullptr)));
  }));
}

TEST_CASE("a binary number is read exactly and comes back") {
  CHECK(rc::check([] {
    const double value = *any_double();
    RC_ASSERT(same(Rational::from_double(value).to_double(), value));
    RC_ASSERT(Rational::from_double(-value) == -Rational::from_double(value));
  }));
  CHECK(Rational::from_double(0.1).str() == "3602879701896397/36028797018963968");
  CHECK(Rational::from_double(5e-324) == Rational(2).pow(-1074));
  CHECK(Rational::from_double(-0.0) == 0);
  CHECK_THROWS_AS(Rational::from_double(kInfinity), BadInput);
  CHECK_THROWS_AS(Rational::from_double(std::nan("")), BadInput);
}

TEST_CASE("half way between two binary64 numbers the even one wins, and a hair decides otherwise") {
  const Rational hair = Rational(2).pow(-3000);
  CHECK(rc::check([&] {
    const double low = *any_double();
    const double high = std::nextafter(low, kInfinity);
    RC_PRE(std::isfinite(high));
    const Rational middle = (Rational::from_double(low) + Rational::from_double(high)) / 2;
    const bool low_is_even = std::bit_cast<std::uint64_t>(low) % 2 == 0;
    RC_ASSERT(same(middle.to_double(), low_is_even ? low : high));
    RC_ASSERT(same((middle - hair).to_double(), low));
    RC_ASSERT(same((middle + hair).to_double(), high));
    RC_ASSERT(same((-middle).to_double(), low_is_even ? -low : -high));
  }));
}

TEST_CASE("half way between two binary32 numbers the even one wins: rounding happens once") {
  const Rational hair = Rational(2).pow(-200);
  CHECK(rc::check([&] {
    const float low = std::bit_cast<float>(*random::whole<std::uint32_t>(0, 0x7F7FFFFF));
    const float high = std::nextafter(low, std::numeric_limits<float>::infinity());
    RC_PRE(std::isfinite(high));
    const Rational middle = (Rational::from_double(low) + Rational::from_double(high)) / 2;
    RC_ASSERT(same(middle.to_float(), std::bit_cast<std::uint32_t>(low) % 2 == 0 ? low : high));
    // Through binary64 these two would round to the middle first.
    RC_ASSERT(same((middle - hair).to_float(), low));
    RC_ASSERT(same((middle + hair).to_float(), high));
  }));
}

TEST_CASE("what is too large becomes infinite, what is too small becomes zero with its sign") {
  const Rational top = Rational(2).pow(1024) - Rational(2).pow(970);  // half a unit above the largest
  CHECK(same(top.to_double(), kInfinity));
  CHECK(same((-top).to_double(), -kInfinity));
  CHECK(same((top - 1).to_double(), std::numeric_limits<double>::max()));
  const double most = std::numeric_limits<double>::max();
  CHECK(same((Rational::from_double(most) - Rational(1, 3)).to_double(), most));
  CHECK(same(Rational(10).pow(5000).to_double(), kInfinity));
  const Rational top32 = Rational(2).pow(128) - Rational(2).pow(103);
  CHECK(same(top32.to_float(), std::numeric_limits<float>::infinity()));
  CHECK(same((top32 - 1).to_float(), std::numeric_limits<float>::max()));
  CHECK(same(Rational(10).pow(60).to_float(), std::numeric_limits<float>::infinity()));
  const Rational bottom = Rational(2).pow(-1075);  // half the smallest
  CHECK(same(bottom.to_double(), 0.0));
  CHECK(same((-bottom).to_double(), -0.0));
  CHECK(same((bottom * 3 / 2).to_double(), 5e-324));
  CHECK(same(Rational(2).pow(-150).to_float(), 0.0f));
  CHECK(same((Rational(2).pow(-150) * 3 / 2).to_float(), std::numeric_limits<float>::denorm_min()));
  CHECK(same(Rational(10).pow(-5000).to_double(), 0.0));
  CHECK(same(Rational(0).to_double(), 0.0));
}

TEST_CASE("the quotient of two words is rounded once") {
  CHECK(rc::check([](const Rational& a) {
    const double low = a.to_double();
    RC_PRE(std::isfinite(low));
    const Rational distance = (a - Rational::from_double(low)).abs();
    for (const double neighbour : {std::nextafter(low, kInfinity), std::nextafter(low, -kInfinity)})
      if (std::isfinite(neighbour)) RC_ASSERT(distance <= (a - Rational::from_double(neighbour)).abs());
  }));
  CHECK(same(Rational(1, 3).to_double(), 1.0 / 3.0));
  CHECK(same(Rational(1, 10).to_float(), 0.1f));
  CHECK(same(Rational(16777217).to_float(), 16777216.0f));
  CHECK(same(Rational(9007199254740993).to_double(), 9007199254740992.0));
}
