// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/accumulator.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/algebra/error.hpp"

using namespace shortfall;

namespace {

using End = AccumulatorPath::End;
AccumulatorPath path(const Rational& start, const Rational& increment, const BinaryFormat& format,
                     Rounding rounding, const Rational& least) {
  return accumulator_path({format, rounding, start, increment}, least);
}

constexpr std::array<Rounding, 5> kRoundings{Rounding::nearest_even, Rounding::nearest_away,
                                             Rounding::toward_zero, Rounding::up, Rounding::down};

/// All numbers of a small format.
std::vector<Rational> numbers(const BinaryFormat& f) {
  std::vector<Rational> result{0};
  Rational unit = f.smallest();
  for (long e = f.least_unit; e + f.precision - 1 <= f.greatest_bit; ++e, unit *= Rational(2))
    for (int m = e == f.least_unit ? 1 : 1 << (f.precision - 1); m < 1 << f.precision; ++m) {
      result.push_back(Rational(m) * unit);
      result.push_back(Rational(-m) * unit);
    }
  return result;
}

/// Against one addition after the other, each rounded by itself.
void compare(const Rational& start, const Rational& increment, const BinaryFormat& format, Rounding rounding,
             int most) {
  const AccumulatorPath a = path(start, increment, format, rounding, most);
  Rational value = start;
  bool all_exact = true;
  INFO(start.str() << " += " << increment.str() << ", precision " << format.precision << ", rounding "
                   << static_cast<int>(rounding));
  for (int n = 0; n <= most; ++n) {
    if (a.after(n) != value) {
      FAIL_CHECK("after " << n);
      return;
    }
    if (all_exact && a.exact_additions() < Rational(n)) {
      FAIL_CHECK("exact for longer than " << a.exact_additions().str());
      return;
    }
    const auto next = rounded(value + increment, format, rounding);
    if (!next) {
      if (a.end != End::overflowed || a.additions() != Rational(n) || a.after(n + 1)) FAIL_CHECK("overflow");
      return;
    }
    if (all_exact && *next != value + increment) {
      all_exact = false;
      if (a.exact_additions() != Rational(n)) FAIL_CHECK("rounds for the first time after " << n);
    }
    if (*next == value) {
      if (a.end != End::frozen || a.additions() != Rational(n)) FAIL_CHECK("freezes after " << n);
      if (a.after(Rational(10).pow(30)) != value) FAIL_CHECK("moves again");
      return;
    }
    value = *next;
  }
}

}  // namespace

TEST_CASE("every start and every increment of small formats, in every rounding, as one adds" *
          doctest::test_suite("thorough")) {
  for (const BinaryFormat& f : {BinaryFormat{2, -3, 2}, BinaryFormat{3, -3, 2}, BinaryFormat{4, -5, 2}}) {
    const std::vector<Rational> all = numbers(f);
    for (const Rational& start : all)
      for (const Rational& increment : all) {
        if (increment.is_zero()) continue;
        for (const Rounding r : kRoundings) compare(start, increment, f, r, 200);
      }
  }
}

TEST_CASE("random starts and increments in formats of 5 to 8 bits, fused increments besides") {
  std::mt19937_64 generator(2);
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const BinaryFormat f{5 + static_cast<int>(generator() % 4), -10, 6};
    const auto pick = [&](int scale) {
      return Rational(static_cast<std::int64_t>(generator() % 2001) - 1000) * Rational(2).pow(scale);
    };
    const auto start = rounded(pick(-static_cast<int>(generator() % 14) - 3), f);
    Rational increment = pick(-static_cast<int>(generator() % 8) - 9);
    if (repeat % 2 == 0) increment = rounded(increment, f).value_or(1);
    if (!start || increment.is_zero()) continue;
    compare(*start, increment, f, kRoundings[generator() % kRoundings.size()], 700);
  }
}

TEST_CASE("the processor's float and double agree, for random steps and starts") {
  std::mt19937_64 generator(3);
  const auto random = [&](auto zero, int scale) {
    using Float = decltype(zero);
    const Float m = static_cast<Float>(std::uniform_real_distribution<double>(-1, 1)(generator));
    return std::ldexp(m, scale);
  };
  const auto agree = [&](auto start, auto dt, long n, const BinaryFormat& f) {
    using Float = decltype(start);
    if (dt == 0) return;
    const AccumulatorPath a =
        path(Rational::from_double(start), Rational::from_double(dt), f, Rounding::nearest_even, n);
    volatile Float t = start;
    for (long i = 0; i < n; ++i) t = t + dt;
    CHECK(a.after(n) == Rational::from_double(t));
  };
  for (int repeat = 0; repeat < 60; ++repeat) {
    const int scale = static_cast<int>(generator() % 40) - 20;
    const long n = static_cast<long>(generator() % 300'000);
    const int apart = static_cast<int>(generator() % 24);
    agree(random(0.0F, scale + apart), random(0.0F, scale), n, BinaryFormat::binary32());
    agree(random(0.0, scale + 2 * apart), random(0.0, scale), n, BinaryFormat::binary64());
  }
  agree(0.0F, 1.0F / 60, 10'000'000, BinaryFormat::binary32());
  agree(-3.0F, 1e-7F, 10'000'000, BinaryFormat::binary32());
  agree(0.0F, std::ldexp(3.0F, -149), 9'000'000, BinaryFormat::binary32());
  agree(0.0, 0.1, 10'000'000, BinaryFormat::binary64());
}

TEST_CASE("the known stopping points of binary32 clocks") {
  const BinaryFormat f = BinaryFormat::binary32();
  const AccumulatorPath tenth =
      path(0, Rational(1, 10).to_float() == 0.1F ? Rational::from_double(0.1F) : Rational(), f,
           Rounding::nearest_even, Rational(10).pow(18));
  CHECK(tenth.after(1'000'000) == Rational(3230667, 32));
  CHECK(tenth.end == End::frozen);
  CHECK(tenth.additions() == Rational(18073720));
  CHECK(tenth.last() == Rational(2).pow(21));
  CHECK(tenth.after(Rational(10).pow(18)) == Rational(2).pow(21));
  const AccumulatorPath frame = path(0, Rational::from_double(1.0F / 60), f, Rounding::nearest_even, 1);
  CHECK(frame.additions() == Rational(24986955));
  CHECK(frame.last() == Rational(2).pow(19));
  const AccumulatorPath dyadic = path(0, Rational(1, 64), f, Rounding::nearest_even, 1);
  CHECK(dyadic.exact_additions() == Rational(2).pow(24));
  CHECK(dyadic.last() == Rational(2).pow(18));
}

TEST_CASE(
    "a clock that is rounded up never stops but at infinity, and far ends are not pretended to be known") {
  const AccumulatorPath up =
      path(0, Rational::from_double(0.1), BinaryFormat::binary64(), Rounding::up, Rational(10).pow(18));
  CHECK(up.end == End::overflowed);
  CHECK(up.last() == BinaryFormat::binary64().largest());
  const AccumulatorPath wide =
      path(0, 1, BinaryFormat::of_precision(200), Rounding::up, Rational(10).pow(18));
  CHECK(wide.end == End::not_reached);
  CHECK(wide.after(Rational(10).pow(18)) == Rational(10).pow(18));
  CHECK_THROWS_AS((void)path(0, 1, BinaryFormat::of_precision(3), Rounding::up, Rational(10).pow(18)),
                  Unable);
  const AccumulatorPath stays =
      path(0, 1, BinaryFormat::binary16(), Rounding::toward_zero, Rational(10).pow(6));
  CHECK(stays.end == End::frozen);
  CHECK(stays.last() == Rational(2048));
  CHECK_THROWS_AS((void)path(Rational(1, 3), 1, BinaryFormat::binary16(), Rounding::up, 1), BadInput);
  CHECK_THROWS_AS((void)path(0, Rational(1, 3), BinaryFormat::binary16(), Rounding::up, 1), BadInput);
}
