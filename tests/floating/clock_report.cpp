// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/clock.hpp"

using namespace shortfall;

namespace {

using Alternative = ClockAlternative::Kind;

ClockQuestion clock_question(const char* format, const Rational& dt, const Rational& additions) {
  ClockQuestion q;
  static_cast<ClockArithmetic&>(q) = clock_arithmetic(format);
  q.dt = dt;
  q.additions = additions;
  return q;
}

const ClockAlternative& found(const ClockReport& r, Alternative kind) {
  const auto a = std::ranges::find(r.instead, kind, &ClockAlternative::kind);
  REQUIRE(a != r.instead.end());
  return *a;
}

}  // namespace

TEST_CASE("representation and rounding are told apart and add up, for clocks and motions in any rounding" *
          doctest::test_suite("thorough")) {
  std::mt19937_64 generator(11);
  const char* const formats[] = {"f16", "bf16", "f32", "f64", "x87", "f128", "mpfr:20"};
  const char* const roundings[] = {"nearest-even", "nearest-away", "toward-zero", "up", "down"};
  for (int repeat = 0; repeat < 150; ++repeat) {
    const int n = static_cast<int>(generator() % 300);
    ClockQuestion q = clock_question(formats[generator() % 7],
                                     Rational(1 + static_cast<std::int64_t>(generator() % 99), 300), n);
    q.rounding = rounding_named(roundings[generator() % 5]);
    if (generator() % 2) q.velocity = Rational(static_cast<std::int64_t>(generator() % 200) - 100, 7);
    if (generator() % 2) q.start = Rational(static_cast<std::int64_t>(generator() % 2000) - 1000, 3);
    q.fused = generator() % 3 == 0;
    if (q.velocity && q.velocity->is_zero()) continue;
    const auto stored = [&](const Rational& x) { return *rounded(x, q.format, q.rounding); };
    // One addition after the other.
    const Rational product = stored(q.dt) * (q.velocity ? stored(*q.velocity) : Rational(1));
    Rational value = stored(q.start);
    for (int i = 0; i < n; ++i) value = stored(value + (q.fused || !q.velocity ? product : stored(product)));
    const ClockReport r = clock_report(q);
    CHECK(r.value == value);
    CHECK(r.shortfall == q.start + Rational(n) * q.advance() - value);
    CHECK(r.representation == q.start - stored(q.start) + Rational(n) * (q.advance() - product));
    CHECK(*r.rounding_part + r.representation == *r.shortfall);
  }
}

TEST_CASE("the Patriot clock is a fixed-point clock with 23 bits after the point, chopped") {
  ClockQuestion q = clock_question("fixed:23", Rational(1, 10), 3'600'000);
  q.rounding = Rounding::toward_zero;
  const ClockReport r = clock_report(q);
  CHECK(r.shortfall == Rational(5625, 16384));
  CHECK(r.rounding_part == Rational(0));
  CHECK(r.path.end == AccumulatorPath::End::overflowed);
  CHECK(r.path.additions() == ((Rational(2).pow(40) - Rational(2).pow(-23)) / r.stored_dt).floor());
}

TEST_CASE("the speed of each binade is what a running float clock shows there") {
  ClockQuestion q = clock_question("f32", Rational(1, 60), 24'000'000);
  q.kept_dt = Rational::from_double(1.0F / 60);
  const ClockReport r = clock_report(q);
  Rational sum;
  volatile float t = 0;
  std::int64_t n = 0;
  for (const ClockSpeed& s : r.speeds) {
    CHECK(s.before == sum);
    sum += s.additions;
    std::int64_t first = 0, additions = 0;
    REQUIRE(s.before.fits_int64(first));
    REQUIRE(s.additions.fits_int64(additions));
    if (additions < 4) continue;
    CHECK(s.entering <= Rational(2));
    for (; n < first + additions / 2; ++n) t = t + 1.0F / 60;
    const Rational before = Rational::from_double(t);
    t = t + 1.0F / 60;
    ++n;
    CHECK(Rational::from_double(t) - before == s.increment);
    CHECK(s.rate == s.increment * Rational(60));
    CHECK(s.lost_per_hour() == (Rational(1) - s.rate) * Rational(3600));
  }
  CHECK(sum == r.freezes->additions);
}

TEST_CASE("what is offered instead is what these programs compute") {
  ClockQuestion q = clock_question("f32", Rational(1, 60), 5'184'000);
  q.kept_dt = Rational::from_double(1.0F / 60);
  const ClockReport r = clock_report(q);
  const volatile float count = 5'184'000;
  CHECK(found(r, Alternative::divided).value == Rational::from_double(count / 60.0F));
  CHECK(found(r, Alternative::multiplied).value == Rational::from_double(count * (1.0F / 60)));
  CHECK(r.by_multiplication == found(r, Alternative::multiplied).value);
  volatile double wide = 0;
  for (int i = 0; i < 5'184'000; ++i) wide = wide + 1.0 / 60;
  CHECK(found(r, Alternative::wider).value == Rational::from_double(wide));
  CHECK(found(r, Alternative::dyadic).step == Rational(1, 64));
  CHECK(found(r, Alternative::dyadic).exact_additions == Rational(1 << 24));
  CHECK(found(r, Alternative::compensated).shortfall == Rational(-1, 128));
  // A step that is a power of two already needs no other.
  const ClockReport dyadic = clock_report(clock_question("f32", Rational(1, 64), 100));
  CHECK(std::ranges::find(dyadic.instead, Alternative::dyadic, &ClockAlternative::kind) ==
        dyadic.instead.end());
}

TEST_CASE("a motion with a fused product is that of fma") {
  ClockQuestion q = clock_question("f32+fma", Rational(1, 10), 200'000);
  q.velocity = Rational(1, 3);
  const ClockReport r = clock_report(q);
  volatile float x = 0;
  const volatile float v = 1.0F / 3, dt = 0.1F;
  for (int i = 0; i < 200'000; ++i) x = std::fmaf(v, dt, x);
  CHECK(r.value == Rational::from_double(x));
}

TEST_CASE("a compensated question is answered by Kahan's sum, the plain one beside it") {
  ClockQuestion q = clock_question("f64+kahan", Rational(1, 10), Rational(10).pow(15));
  const ClockReport r = clock_report(q);
  REQUIRE(r.kahan);
  CHECK(r.kahan->kind == CompensatedClock::Kind::closed_form);
  CHECK(r.value == rounded(Rational(10).pow(15) * Rational::from_double(0.1), q.format));
  CHECK(r.run.value == accumulated({q.format, q.rounding, 0, Rational::from_double(0.1)}, q.additions).value);
  q.additions = Rational(10).pow(30);
  CHECK(!clock_report(q).value);
}

TEST_CASE("questions without an answer are refused in a sentence") {
  CHECK_THROWS_AS(clock_report(clock_question("f32", 0, 1)), BadInput);
  CHECK_THROWS_AS(clock_report(clock_question("f32", 1, -1)), BadInput);
  CHECK_THROWS_AS(clock_report(clock_question("f32", 1, Rational(1, 2))), BadInput);
  CHECK_THROWS_AS(clock_report(clock_question("f16", 100'000, 1)), BadInput);
  ClockQuestion still = clock_question("f32", 1, 1);
  still.velocity = 0;
  CHECK_THROWS_AS(clock_report(still), BadInput);
  CHECK_THROWS_WITH_AS(clock_arithmetic("f23"), doctest::Contains("did you mean 'f32'"), BadInput);
  CHECK_THROWS_AS(clock_arithmetic("fixed:64"), BadInput);
  CHECK_THROWS_AS(clock_arithmetic("fixed"), BadInput);
  CHECK_THROWS_AS(clock_arithmetic("fixed:1x"), BadInput);
  CHECK_THROWS_AS(clock_arithmetic("dd"), Unable);
  CHECK_THROWS_AS(clock_arithmetic("f32+origin"), Unable);
  CHECK_THROWS_WITH_AS(rounding_named("towards-zero"), doctest::Contains("did you mean 'toward-zero'"),
                       BadInput);
}
