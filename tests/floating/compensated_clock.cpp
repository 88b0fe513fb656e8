// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/compensated_clock.hpp"

#include <doctest/doctest.h>

#include <array>
#include <optional>
#include <random>

using namespace shortfall;

namespace {

using Kind = CompensatedClock::Kind;

/// Kahan's sum, each operation rounded by itself.
std::optional<Rational> kahan(const Rational& start, const Rational& increment, const BinaryFormat& f,
                              Rounding r, int n) {
  Rational s = start, c;
  for (int i = 0; i < n; ++i) {
    const auto y = rounded(increment - c, f, r);
    if (!y) return std::nullopt;
    const auto t = rounded(s + *y, f, r);
    if (!t) return std::nullopt;
    const auto moved = rounded(*t - s, f, r);
    if (!moved) return std::nullopt;
    c = rounded(*moved - *y, f, r).value();
    s = *t;
  }
  return s;
}

}  // namespace

TEST_CASE("Kahan's sum in small formats: the closed form where it is claimed, steps and bound elsewhere") {
  std::mt19937_64 generator(4);
  int closed = 0, stepped = 0, bounded = 0;
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const BinaryFormat f{3 + static_cast<int>(generator() % 6), -12, 9};
    const Rounding r = repeat % 4 == 0 ? Rounding::nearest_away : Rounding::nearest_even;
    const auto pick = [&] {
      return Rational(static_cast<std::int64_t>(generator() % 401) - 200) *
             Rational(2).pow(-static_cast<int>(generator() % 12));
    };
    const auto start = repeat % 3 == 0 ? std::optional<Rational>(0) : rounded(pick(), f, r);
    const auto increment = rounded(pick(), f, r);
    const int n = static_cast<int>(generator() % 200);
    if (!start || !increment || increment->is_zero()) continue;
    INFO(start->str() << " += " << increment->str() << ", " << n << " times, precision " << f.precision);
    const auto truth = kahan(*start, *increment, f, r, n);
    const CompensatedClock all = compensated_clock(*start, *increment, f, r, n, 1000);
    CHECK(all.kind != Kind::unknown);
    CHECK(all.value == truth);
    closed += all.kind == Kind::closed_form;
    stepped += all.kind == Kind::stepped;
    const CompensatedClock none = compensated_clock(*start, *increment, f, r, n, 0);
    if (none.kind != Kind::bounded) continue;
    ++bounded;
    REQUIRE(truth);
    CHECK((*start + Rational(n) * *increment - *truth).abs() <= *none.bound);
  }
  CHECK(closed > 500);
  CHECK(stepped > 500);
  CHECK(bounded > 100);
}

TEST_CASE("the other roundings are stepped through") {
  std::mt19937_64 generator(5);
  for (const Rounding r : {Rounding::toward_zero, Rounding::up, Rounding::down})
    for (int repeat = 0; repeat < 100; ++repeat) {
      const BinaryFormat f{6, -20, 30};
      const Rational increment = Rational(1 + static_cast<std::int64_t>(generator() % 63), 64);
      const int n = 1 + static_cast<int>(generator() % 300);
      const CompensatedClock c = compensated_clock(0, increment, f, r, n, 1000);
      CHECK(c.kind == Kind::stepped);
      CHECK(c.value == kahan(0, increment, f, r, n));
    }
}

TEST_CASE("Kahan's sum of the processor's float and double") {
  const auto native = [](auto dt, long n) {
    using Float = decltype(dt);
    volatile Float s = 0, c = 0;
    for (long i = 0; i < n; ++i) {
      const volatile Float y = dt - c;
      const volatile Float t = s + y;
      const volatile Float moved = t - s;
      c = moved - y;
      s = t;
    }
    return Rational::from_double(s);
  };
  const auto ours = [](double dt, const BinaryFormat& f, long n) {
    return compensated_clock(0, Rational::from_double(dt), f, Rounding::nearest_even, n, n);
  };
  const CompensatedClock tenth = ours(0.1F, BinaryFormat::binary32(), 1'000'000);
  CHECK(tenth.kind == Kind::closed_form);
  CHECK(tenth.value == native(0.1F, 1'000'000));
  const CompensatedClock longer = ours(0.1F, BinaryFormat::binary32(), 7'000'000);
  CHECK(longer.kind == Kind::stepped);
  CHECK(longer.value == native(0.1F, 7'000'000));
  CHECK(ours(0.1, BinaryFormat::binary64(), 3'000'000).value == native(0.1, 3'000'000));
}

TEST_CASE("beyond what can be stepped through, a bound is said, and no value") {
  const CompensatedClock c = compensated_clock(0, Rational::from_double(0.1F), BinaryFormat::binary32(),
                                               Rounding::nearest_even, 12'000'000, 1'000'000);
  CHECK(c.kind == Kind::bounded);
  CHECK(!c.value);
  const CompensatedClock known = compensated_clock(0, Rational::from_double(0.1F), BinaryFormat::binary32(),
                                                   Rounding::nearest_even, 12'000'000, 12'000'000);
  REQUIRE(known.value);
  CHECK((Rational(12'000'000) * Rational::from_double(0.1F) - *known.value).abs() <= *c.bound);
}

TEST_CASE("a compensated sum stops too, much later") {
  const CompensatedClock c =
      compensated_clock(0, Rational(11, 16), {4, -30, 30}, Rounding::nearest_even, 100'000, 100'000);
  REQUIRE(c.frozen_after);
  CHECK(c.value == kahan(0, Rational(11, 16), {4, -30, 30}, Rounding::nearest_even, 3000));
}
