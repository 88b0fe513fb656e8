// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/binary_format.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace shortfall;

TEST_CASE(
    "rounding to binary32 and binary64 is that of the processor, ties, subnormals and overflow included") {
  std::mt19937_64 generator(1);
  for (int repeat = 0; repeat < 4000; ++repeat) {
    const int shift = std::uniform_int_distribution<int>(-1100, 1000)(generator);
    const Rational value = Rational(static_cast<std::int64_t>(generator())) * Rational(2).pow(shift) /
                           Rational(1 + static_cast<std::int64_t>(generator() % 5));
    const double d = value.to_double();
    const auto ours = rounded(value, BinaryFormat::binary64());
    CHECK(ours.has_value() == std::isfinite(d));
    if (ours) CHECK(*ours == Rational::from_double(d));
    const float f = value.to_float();
    const auto ours32 = rounded(value, BinaryFormat::binary32());
    CHECK(ours32.has_value() == std::isfinite(f));
    if (ours32) CHECK(*ours32 == Rational::from_double(f));
  }
}

TEST_CASE("a tiny format, by its list of numbers, in every direction") {
  const BinaryFormat format{3, -4,
                            1};  // 0, 1/16 .. 3/16, then 4/16 .. 7/16 in 1/16, 8/16 .. 14/16 in 2/16, ... 3.5
  std::vector<Rational> numbers{0};
  for (int e = -4; e <= -1; ++e)
    for (int m = e == -4 ? 1 : 4; m < 8; ++m) numbers.push_back(Rational(m) * Rational(2).pow(e));
  CHECK(numbers.back() == format.largest());
  CHECK(numbers[1] == format.smallest());
  for (int k = 0; k <= 4 * 56; ++k) {
    const Rational value(k, 64);
    std::size_t below = 0;
    while (below + 1 < numbers.size() && numbers[below + 1] <= value) ++below;
    const Rational low = numbers[below];
    if (value > format.largest()) continue;
    const Rational high = low == value ? low : numbers[below + 1];
    CHECK(rounded(value, format, Rounding::toward_zero) == low);
    CHECK(rounded(value, format, Rounding::down) == low);
    CHECK(rounded(value, format, Rounding::up) == high);
    CHECK(rounded(-value, format, Rounding::up) == -low);
    const Rational to_low = value - low, to_high = high - value;
    if (to_low != to_high) {
      CHECK(rounded(value, format) == (to_low < to_high ? low : high));
    } else if (low != high) {
      CHECK(rounded(value, format, Rounding::nearest_away) == high);
      CHECK(rounded(value, format) == (below % 2 == 0 ? low : high));
    }
  }
  CHECK(!rounded(Rational(15, 4), format));  // the tie above the largest
  CHECK(rounded(Rational(374, 100), format) == Rational(7, 2));
  CHECK(rounded(Rational(100), format, Rounding::toward_zero) == Rational(7, 2));
  CHECK(!rounded(Rational(100), format, Rounding::up));
}
