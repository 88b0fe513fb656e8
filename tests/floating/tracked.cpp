// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/tracked.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/floating/small_float.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/floating/float_question.hpp"

using namespace shortfall;

using testing::moving_body;

namespace {

Rational exactly(double value) { return Rational::from_double(value); }
Rational exactly(float value) { return Rational::from_double(value); }
Rational exactly(const Binary16& value) { return Rational::from_double(value.value()); }

/// value + error, as a rational number.
template <class T>
Rational whole(const Tracked<T>& x) {
  return exactly(x.value()) + exactly(x.error());
}

/// |a - b| <= |b| 2^-bits.
bool close(const Rational& a, const Rational& b, int bits) {
  return (a - b).abs() * Rational(2).pow(bits) <= b.abs();
}

template <class T>
void check_operations(const std::function<T()>& any, int bits) {
  for (int repeat = 0; repeat < 300; ++repeat) {
    const T a = any(), b = any(), c = any();
    const Rational x = exactly(a), y = exactly(b), z = exactly(c);
    const Tracked<T> p(a), q(b), r(c);
    // What one operation rounds off is a number of the format: found without any error.
    CHECK(whole(p + q) == x + y);
    CHECK(whole(p - q) == x - y);
    CHECK(whole(p * q) == x * y);
    CHECK((p + q).value() == a + b);
    CHECK((p * q).value() == a * b);
    CHECK(whole(a * q) == x * y);
    CHECK(close(whole(a * (q + r)), x * (y + z), bits));
    CHECK(close(whole(p / q), x / y, bits));
    CHECK((p / q).value() == a / b);
    CHECK(close(whole(fma(p, q, r)) - x * y, z, bits - 4));
    const Tracked<T> root = sqrt(p * p);
    CHECK(close(whole(root), x.abs(), bits));
    // Two operations: the first one's error goes through the second.
    CHECK(close(whole((p + q) * r), (x + y) * z, bits));
    CHECK(close(whole((p * q) * (q * r)), x * y * y * z, bits));
    if (!(x * y + z).is_zero()) CHECK(close(whole(r / (p * q)), z / (x * y), bits));
  }
}

}  // namespace

TEST_CASE("errors of single operations are exact, and go through further ones") {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number(0.5, 9);
  check_operations<double>([&] { return number(generator) * (generator() % 2 != 0 ? 1 : -1); }, 100);
  check_operations<float>([&] { return static_cast<float>(number(generator)); }, 70);
  check_operations<Binary16>([&] { return Binary16(number(generator)); }, 50);
}

TEST_CASE("functions carry errors through their slopes") {
  const Tracked<double> a(0.7, 1e-17);
  // exp(0.7 + 1e-17) - the binary64 exp(0.7), by its series in rationals
  Rational sum, term = 1;
  const Rational at = exactly(0.7) + exactly(1e-17);
  for (int n = 1; n < 40; ++n) {
    sum += term;
    term = term * at / Rational(n);
  }
  CHECK(exp(a).value() == std::exp(0.7));
  CHECK(close(whole(exp(a)), sum, 100));
  CHECK(close(whole(log(exp(a))), at, 98));
  CHECK(close(whole(pow(a, Tracked<double>(3))), at * at * at, 98));
}

TEST_CASE("the trajectory is the same bit for bit, and what is tracked is the exact rounding") {
  std::mt19937 generator(23);
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  const std::vector<std::string> forces{"constant:a=-9", "poly:2:f0=1,f1=-1/3,f2=2/7", "spring:k=3",
                                        "damped-spring:k=2,c=1/3", "drag:a=-9,c=1/4"};
  const std::vector<std::string> formats{"f16",       "bf16",    "f32",       "f64",      "x87",
                                         "f32+kahan", "f64+fma", "f64+kahan", "bf16+fma", "f16+kahan"};
  int compared = 0;
  for (int repeat = 0; repeat < 110; ++repeat) {
    const std::vector<Program>& all = catalogue();
    const Program& program = all[static_cast<std::size_t>(pick(0, static_cast<int>(all.size()) - 1))];
    if (family(program) == "engines") continue;
    FloatQuestion q = moving_body(program.name, forces[static_cast<std::size_t>(pick(0, 4))],
                                  Rational(pick(1, 9), pick(20, 60)));
    q.substeps = pick(1, 2);
    const FloatFormat format = float_format(formats[static_cast<std::size_t>(pick(0, 9))]);
    CAPTURE(program.name);
    CAPTURE(q.force.text);
    CAPTURE(format.name());
    const auto plain = float_run(format, q), tracked = tracked_run(format, q);
    REQUIRE(tracked);
    CHECK_FALSE(plain->rounding().has_value());
    std::unique_ptr<FloatRun> exact;
    try {
      exact = exact_run(stored(q, format));
      exact->step();  // some square roots are met here
      exact->begin();
    } catch (const Unable&) {
      continue;
    }
    const Rational unit = Rational(1, 2).pow(format.storage().precision);
    for (int n = 1; n <= 12; ++n) {
      plain->step();
      tracked->step();
      exact->step();
      const auto [x, v] = plain->state();
      const auto [tracked_x, tracked_v] = tracked->state();
      REQUIRE(x.is_finite());
      CHECK(tracked_x.value == x.value);
      CHECK(tracked_v.value == v.value);
      const auto [ex, ev] = exact->state();
      const auto [rx, rv] = *tracked->rounding();
      // Against the rounding itself, and against a unit of what was rounded: sums may cancel.
      const Rational size = x.value.abs() + v.value.abs() + Rational(1);
      const auto agrees = [&](double error, const Rational& truth) {
        return (exactly(error) - truth).abs() <= (truth.abs() + unit * size) * Rational(10).pow(-8);
      };
      CHECK(agrees(rx, ex.value - x.value));
      CHECK(agrees(rv, ev.value - v.value));
    }
    ++compared;
  }
  CHECK(compared >= 45);
}

TEST_CASE("100,000 steps: the rounding of the budget, to ten digits") {
  for (const char* format : {"f32", "f64", "f64+fma", "f32+kahan"}) {
    CAPTURE(format);
    const Budget b =
        budget(float_format(format), moving_body("velocity-verlet", "spring:k=1", Rational(1, 10)), 100'000);
    REQUIRE(b.tracked.has_value());
    for (std::size_t i : {0U, 1U}) {
      const BudgetLine& l = b.lines[i];
      CHECK(l.closes());
      const double tracked = i == 0 ? b.tracked->first : b.tracked->second;
      const double exact = l.terms.back().value.to_double();
      CHECK(std::abs(tracked - exact) <= 1e-10 * std::abs(exact));
    }
  }
}

TEST_CASE("where no exact map is known, rounding is, as tracked beside the run") {
  FloatQuestion q = moving_body("symplectic-euler", "spring:k=1", Rational(1, 10));
  q.program = parse(
      "integrator slower\n"
      "step\n"
      "  v = v + h*a(x, v, t)\n"
      "  x = x + (h - t/100)*v\n",
      "slower.integrator");
  const FloatFormat f32 = float_format("f32");
  const Budget b = budget(f32, q, 15);
  CHECK(b.lines.empty());
  CHECK(!b.reason.empty());
  CHECK(b.difference.rounding->line == 3);
  const auto exact = exact_run(stored(q, f32)), run = float_run(f32, q);
  for (int n = 0; n < 15; ++n) {
    exact->step();
    run->step();
  }
  REQUIRE(b.tracked.has_value());
  const double truth = (exact->state().first.value - run->state().first.value).to_double();
  CHECK(std::abs(b.tracked->first - truth) < 1e-8 * std::abs(truth));
  CHECK_THROWS_AS(budget(float_format("mpfr:20"), q, 15), Unable);
}

TEST_CASE("formats whose roundings are no numbers of theirs are not tracked") {
  const FloatQuestion q = moving_body("velocity-verlet", "spring:k=1", Rational(1, 10));
  for (const char* format : {"f128", "dd", "mpfr:50", "f32+origin", "f64+tozero", "f16+tozero"})
    CHECK(tracked_run(float_format(format), q) == nullptr);
}
