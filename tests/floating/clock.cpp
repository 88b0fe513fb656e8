// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/clock.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

namespace {

Accumulator binary32_clock(float dt) {
  return {BinaryFormat::binary32(), Rounding::nearest_even, 0, Rational::from_double(dt)};
}

/// By adding.
std::optional<Rational> added(const Accumulator& c, int n) {
  Rational value = c.start;
  for (int k = 0; k < n; ++k) {
    const auto next = rounded(value + c.increment, c.format, c.rounding);
    if (!next) return std::nullopt;
    value = *next;
  }
  return value;
}

}  // namespace

TEST_CASE("clocks in binary32 as they are known to go wrong") {
  CHECK(accumulated(binary32_clock(0.1f), 1'000'000).value == Rational(3230667, 32));
  auto freeze = freezing_point(binary32_clock(0.1f));
  REQUIRE(freeze.has_value());
  CHECK(freeze->value == Rational(1 << 21));
  CHECK(freeze->additions == Rational(18073720));
  freeze = freezing_point(binary32_clock(1 / 60.0f));
  REQUIRE(freeze.has_value());
  CHECK(freeze->value == Rational(1 << 19));
  CHECK(freeze->additions == Rational(24986955));
  // A dyadic step is exact as long as the sum has 24 bits.
  const Accumulation dyadic = accumulated(binary32_clock(1 / 64.0f), Rational(1 << 25));
  CHECK(dyadic.exact_additions == Rational(1 << 24));
  CHECK(dyadic.value == Rational(1 << 18));
}

TEST_CASE(
    "the Patriot clock: 0.1 s chopped to 24 bits of fixed point is off by 5625/16384 s after 100 hours") {
  // Its register held 0.1 as 209715/2^21; counted in tenths, the product is exact.
  const BinaryFormat register_format{18, -21, 1};
  const Rational kept = *rounded(Rational(1, 10), register_format, Rounding::toward_zero);
  CHECK(kept == Rational(209715, 1 << 21));
  CHECK((Rational(1, 10) - kept) * Rational(3'600'000) == Rational(5625, 16384));
}

TEST_CASE("binary32 and binary64 clocks are those of the processor") {
  std::mt19937_64 generator(5);
  for (int repeat = 0; repeat < 30; ++repeat) {
    const float dt = std::ldexp(1 + static_cast<float>(generator() % 100000) / 100000,
                                -static_cast<int>(generator() % 12));
    const float start = static_cast<float>(generator() % 5000) - 2500;
    const int n = 1 + static_cast<int>(generator() % 300000);
    float t = start;
    for (int k = 0; k < n; ++k) t += dt;
    CHECK(accumulated({BinaryFormat::binary32(), Rounding::nearest_even, Rational::from_double(start),
                       Rational::from_double(dt)},
                      n)
              .value == Rational::from_double(t));
    double d = start;
    for (int k = 0; k < n; ++k) d += static_cast<double>(dt) / 3;
    CHECK(accumulated({BinaryFormat::binary64(), Rounding::nearest_even, Rational::from_double(start),
                       Rational::from_double(static_cast<double>(dt) / 3)},
                      n)
              .value == Rational::from_double(d));
  }
}

TEST_CASE("tiny formats, all starts and increments, every direction, through subnormals, zero and overflow" *
          doctest::test_suite("thorough")) {
  int compared = 0;
  for (const BinaryFormat& format :
       {BinaryFormat{3, -5, 3}, BinaryFormat{4, -4, 2}, BinaryFormat{2, -3, 4}}) {
    std::vector<Rational> numbers;
    for (int k = -600; k <= 600; ++k) {
      const Rational value = Rational(k) * format.smallest();
      if (rounded(value, format) == std::optional<Rational>(value)) numbers.push_back(value);
    }
    for (const Rounding rounding : {Rounding::nearest_even, Rounding::nearest_away, Rounding::toward_zero,
                                    Rounding::up, Rounding::down})
      for (std::size_t s = 0; s < numbers.size(); s += 5)
        for (const Rational& increment : numbers) {
          if (increment.is_zero()) continue;
          const Accumulator clock{format, rounding, numbers[s], increment};
          for (int n : {1, 2, 3, 7, 40, 200}) {
            CHECK(accumulated(clock, n).value == added(clock, n));
            ++compared;
          }
        }
  }
  CHECK(compared > 20'000);
}

TEST_CASE("stretches add up to the value, and a huge number of additions takes no longer") {
  const Accumulation a = accumulated(binary32_clock(0.1f), Rational(10).pow(18));
  CHECK(a.value == Rational(1 << 21));
  Rational sum, count;
  for (const Stretch& s : a.stretches) {
    CHECK(s.from == sum);
    sum += s.added * s.additions;
    count += s.additions;
  }
  CHECK(sum == *a.value);
  CHECK(a.stretches.size() < 100);
  const Accumulation d =
      accumulated({BinaryFormat::binary64(), Rounding::nearest_even, 0, Rational::from_double(0.1)},
                  Rational(10).pow(18));
  CHECK(d.stretches.size() < 200);
}

TEST_CASE("a report tells what is stored from what is rounded") {
  ClockQuestion q;
  q.dt = Rational(1, 10);
  q.additions = 1'000'000;
  const ClockReport r = clock_report(q);
  CHECK(r.meant == Rational(100'000));
  CHECK(r.stored_meant == Rational::from_double(0.1f) * Rational(1'000'000));
  CHECK((r.stored_meant - *r.by_multiplication).abs() < Rational(1, 100));
  q.dt = 0;
  CHECK_THROWS_AS(clock_report(q), BadInput);
  q.dt = Rational(10).pow(60);
  CHECK_THROWS_AS(clock_report(q), BadInput);
  q.dt = Rational(1) / Rational(10).pow(60);
  CHECK_THROWS_AS(clock_report(q), BadInput);
}
