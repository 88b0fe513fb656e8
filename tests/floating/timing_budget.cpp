// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/floating/budget_term.hpp"
#include "tests/floating/float_question.hpp"

using namespace shortfall;

using testing::resting_body, testing::term;

namespace {

/// The first and the last of 2 periods + 1 passings through 0 from above, read as budgets read them.
template <class T, class Step>
T period_by_hand(const T& h, T x, Step&& step, int periods) {
  T first = 0, last = 0, before = x;
  int passed = 0;
  bool above = true;
  for (int n = 1; passed < 2 * periods + 1; ++n) {
    x = step(n);
    if ((x > 0) != above) {
      last = h * (T(n - 1) + before / (before - x));
      if (passed == 0) first = last;
      ++passed;
      above = !above;
    }
    before = x;
  }
  return (last - first) / T(periods);
}

const std::vector<std::string> kFormats{"f16", "bf16",    "f32",       "f64",        "x87",        "f128",
                                        "dd",  "mpfr:30", "f32+kahan", "f32+origin", "f64+tozero", "f64+fma"};

}  // namespace

TEST_CASE("symplectic Euler lands a step early: all of it is the method's, where nothing is rounded") {
  // u = sqrt(2 g H) = 4, and x_n = u n h - g h^2 n (n + 1)/2 is 0 at n = 2 u/(g h) - 1.
  const FloatQuestion q = resting_body("symplectic-euler", "constant", Rational(1, 64));
  const Budget b = landing_budget(float_format("f64"), q, 1, 8);
  const BudgetLine& l = b.lines.at(0);
  CHECK(l.closes());
  CHECK(b.steps == 63);
  CHECK(l.computed.value == Rational(63, 64));
  CHECK(l.truth.contains(1));
  CHECK(term(l, "sampling").is_zero());
  CHECK(term(l, "method").contains(Rational(1, 64)));
  CHECK(term(l, "method").is_exact());
  CHECK(term(l, "representation").is_zero());
  CHECK(term(l, "rounding").is_zero());
  CHECK(l.residual.is_zero());
  REQUIRE(b.remedies.size() == 1);
  CHECK(b.remedies[0].change == "dt = 1/128 s");
  CHECK(b.remedies[0].becomes.contains(Rational(1, 128)));
}

TEST_CASE("between frames a parabola is read by a straight line") {
  // H = 1.7 m, g = 9.81 m/s^2, h = 1/50 s: the chord of the frames about 2 u/g, worked out in long double.
  const FloatQuestion q = resting_body("velocity-verlet", "constant", Rational(1, 50));
  const Budget b = landing_budget(float_format("f32"), q, Rational(17, 10), Rational(981, 100));
  const long double u = std::sqrt(2 * 9.81L * 1.7L), h = 0.02L, truth = 2 * u / 9.81L;
  const auto x = [&](long double n) { return u * n * h - 9.81L / 2 * n * h * n * h; };
  const long double m = std::ceil(truth / h);
  const long double read = h * (m - 1 + x(m - 1) / (x(m - 1) - x(m)));
  const BudgetLine& l = b.lines.at(0);
  CHECK(l.closes());
  CHECK(b.steps == static_cast<std::int64_t>(m));
  CHECK(term(l, "method").contains(0));  // velocity Verlet is on the parabola
  CHECK(std::abs(term(l, "sampling").to_double() - static_cast<double>(truth - read)) < 1e-15);
  CHECK(std::abs(term(l, "rounding").to_double()) < 1e-5);
  CHECK(std::abs(term(l, "representation").to_double()) < 1e-6);
}

TEST_CASE("the period of a spring, beside one that is read by hand") {
  const Rational h(1, 10);
  for (int periods : {1, 3}) {
    CAPTURE(periods);
    const Budget b =
        period_budget(float_format("f64"), resting_body("symplectic-euler", "spring:k=1", h), periods);
    const BudgetLine& l = b.lines.at(0);
    CHECK(l.closes());
    Rational x = 1, v = 0;
    const Rational map = period_by_hand<Rational>(
        h, 1,
        [&](int) {
          v -= h * x;
          x += h * v;
          return x;
        },
        periods);
    const Rational two_pi = Rational::parse("6.28318530717958647692528676655900576839433879875021164");
    CHECK(std::abs((term(l, "sampling") + term(l, "method") - Ball(two_pi - map, 400)).to_double()) < 1e-48);
    const long double seen = period_by_hand<long double>(
        0.1L, 1, [](int n) { return std::cos(0.1L * n); }, periods);
    CHECK(std::abs(term(l, "sampling").to_double() - (two_pi.to_double() - static_cast<double>(seen))) <
          1e-14);
    // A spring of symplectic Euler is too fast, by h^2/24 of its period; what else there is is rounding.
    CHECK(std::abs(term(l, "method").to_double() / (two_pi.to_double() / 2400) - 1) < 0.05);
    CHECK(std::abs(term(l, "rounding").to_double()) < 1e-13);
    double run_x = 1, run_v = 0;
    const double in_double = period_by_hand<double>(
        0.1, 1,
        [&](int) {
          run_v = run_v + 0.1 * -(1 * run_x);
          run_x = run_x + 0.1 * run_v;
          return run_x;
        },
        periods);
    CHECK(std::abs(l.computed.value.to_double() - in_double) < 1e-13);
  }
  // Damped, about a level that is not 0, from rest at the level.
  FloatQuestion q = resting_body("velocity-verlet", "constant:a=3+damped-spring:k=4,c=1/2", Rational(1, 20));
  q.x0 = Rational(3, 4);
  q.v0 = -1;
  const Budget b = period_budget(float_format("f32"), q, 2);
  CHECK(b.lines[0].closes());
  CHECK(std::abs(b.lines[0].truth.to_double() - 2 * M_PI / std::sqrt(4 - 1.0 / 16)) < 1e-14);
}

TEST_CASE("budgets of landings and periods close for random integrators, forces and formats" *
          doctest::test_suite("thorough")) {
  std::mt19937 generator(29);
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  const std::vector<std::string> springs{"spring:k=3", "damped-spring:k=5,c=1/3",
                                         "constant:a=1/3+spring:k=4"};
  int closed = 0;
  for (int repeat = 0; repeat < 50; ++repeat) {
    const std::vector<Program>& all = catalogue();
    const Program& program = all[static_cast<std::size_t>(pick(0, static_cast<int>(all.size()) - 1))];
    if (family(program) == "engines" || program.solves) continue;
    FloatQuestion q = resting_body(program.name, springs[static_cast<std::size_t>(pick(0, 2))],
                                   Rational(pick(1, 4), pick(25, 60)));
    q.x0 = Rational(pick(1, 9), 7);
    q.v0 = Rational(pick(-9, 9), 5);
    const FloatFormat format = float_format(kFormats[static_cast<std::size_t>(pick(0, 11))]);
    CAPTURE(program.name);
    CAPTURE(q.force.text);
    CAPTURE(q.h.str());
    CAPTURE(format.name());
    try {
      const Budget b = repeat % 2 == 0
                           ? period_budget(format, q, pick(1, 3))
                           : landing_budget(format, q, Rational(pick(5, 90), 10), Rational(981, 100));
      if (b.not_finite_at) continue;
      CHECK(b.lines.at(0).closes());
      ++closed;
    } catch (const Unable& e) {
      // A run in 8 bits may stand still; nothing else is refused here.
      CAPTURE(e.what());
      CHECK((format.storage().precision <= 11 ||
             std::string(e.what()).find("passes its level only") != std::string::npos));
    }
  }
  CHECK(closed >= 28);
}

TEST_CASE("what has no period and no landing is refused with a reason") {
  const FloatFormat f32 = float_format("f32");
  CHECK_THROWS_AS(period_budget(f32, resting_body("velocity-verlet", "constant:a=-9", Rational(1, 50)), 1),
                  Unable);
  CHECK_THROWS_AS(
      period_budget(f32, resting_body("velocity-verlet", "damped-spring:k=1,c=3", Rational(1, 50)), 1),
      Undefined);
  CHECK_THROWS_AS(period_budget(f32, resting_body("velocity-verlet", "spring:k=1", 4), 1), Unable);
  CHECK_THROWS_AS(period_budget(f32, resting_body("velocity-verlet", "spring:k=1", Rational(1, 50)), 0),
                  BadInput);
  FloatQuestion rest = resting_body("velocity-verlet", "constant:a=2+spring:k=2", Rational(1, 50));
  CHECK_THROWS_AS(period_budget(f32, rest, 1), Undefined);
  CHECK_THROWS_AS(landing_budget(f32, resting_body("symplectic-euler", "constant", Rational(1, 50)),
                                 Rational(1, 1000), Rational(981, 100)),
                  Unable);
}
