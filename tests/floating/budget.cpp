// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/budget.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/rounding_bound.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/floating/budget_term.hpp"
#include "tests/floating/float_question.hpp"

using namespace shortfall;

using testing::moving_body, testing::resting_body, testing::term;

TEST_CASE("a jump of 1.7 m with symplectic Euler in binary32: every part to its published digits, in mm") {
  FloatQuestion q = moving_body("symplectic-euler", "constant", Rational(1, 50));
  q.kept_h = Rational::from_double(0.02f);
  const Budget b = peak_budget(float_format("f32"), q, Rational(17, 10), Rational(981, 100));
  CHECK(b.steps == 29);
  const BudgetLine& l = b.lines.at(0);
  CHECK(l.closes());
  const auto millimetres = [](const Ball& value, int digits) {
    return (value * Ball(1000, 400)).significant(digits).value();
  };
  CHECK(millimetres(term(l, "sampling"), 9) == "0.372523768");
  CHECK(millimetres(term(l, "method"), 5) == "56.898");
  CHECK(millimetres(term(l, "representation"), 6) == "-0.0000421863");
  CHECK(millimetres(term(l, "rounding"), 6) == "-0.000836845");
  CHECK(millimetres(l.observed, 9) == "57.2696447");
}

TEST_CASE("budgets close for random integrators, forces, steps and formats") {
  std::mt19937 generator(17);
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator);
  };
  const std::vector<std::string> forces{"constant:a=-9",   "poly:2:f0=1,f1=-1/3,f2=2/7",
                                        "spring:k=3",      "damped-spring:k=2,c=1/3",
                                        "drag:a=-9,c=1/4", "constant:a=1/3+spring:k=5"};
  const std::vector<std::string> formats{"f16",        "bf16",       "f32",       "f64",     "x87",
                                         "f128",       "dd",         "mpfr:30",   "f32+fma", "f32+kahan",
                                         "f32+origin", "f64+tozero", "bf16+kahan"};
  int closed = 0;
  for (int repeat = 0; repeat < 120; ++repeat) {
    const std::vector<Program>& all = catalogue();
    const Program& program = all[static_cast<std::size_t>(pick(0, static_cast<int>(all.size()) - 1))];
    if (family(program) == "engines") continue;
    FloatQuestion q = moving_body(program.name, forces[static_cast<std::size_t>(pick(0, 5))],
                                  Rational(pick(1, 9), pick(20, 60)));
    q.substeps = pick(1, 3);
    q.x0 = Rational(pick(-9, 9), 7);
    const FloatFormat format = float_format(formats[static_cast<std::size_t>(pick(0, 12))]);
    CAPTURE(program.name);
    CAPTURE(q.force.text);
    CAPTURE(format.name());
    const int steps = pick(1, 60);
    const Budget b = budget(format, q, steps);
    if (b.not_finite_at) continue;
    for (const BudgetLine& l : b.lines) {
      CAPTURE(l.quantity);
      CHECK(l.closes());
    }
    // What is bounded is bounded.
    if (b.rounding_bound) CHECK(std::abs(term(b.lines[0], "rounding").to_double()) <= *b.rounding_bound);
    ++closed;
  }
  CHECK(closed >= 60);
}

TEST_CASE("each part is what its name says") {
  // A dyadic step and dyadic numbers: nothing is lost by storing.
  FloatQuestion q = moving_body("velocity-verlet", "constant:a=-8", Rational(1, 64));
  q.v0 = Rational(5, 2);
  Budget b = budget(float_format("f64"), q, 100);
  CHECK(term(b.lines[0], "representation").is_zero());
  CHECK(term(b.lines[0], "rounding").is_zero());
  CHECK(term(b.lines[0], "method").is_zero());
  CHECK(b.lines[0].observed.is_zero());
  CHECK_FALSE(b.difference.reported.has_value());
  CHECK(b.difference.compared == 100);
  // So on a spring, whose motion no fraction is; where a number or the step's text is rounded there is a
  // part.
  const auto kept = [](const char* integrator, const char* force, const char* format) {
    return term(budget(float_format(format), moving_body(integrator, force, Rational(1, 8)), 20).lines[0],
                "representation");
  };
  FloatQuestion spring = resting_body("velocity-verlet", "spring:k=3", Rational(1, 8));
  CHECK(term(budget(float_format("f16"), spring, 20).lines[0], "representation").is_zero());
  spring.kept_h = Rational(1, 8) + Rational(1, 1024);
  CHECK_FALSE(term(budget(float_format("f16"), spring, 20).lines[0], "representation").contains_zero());
  CHECK_FALSE(kept("velocity-verlet", "spring:k=3", "f32").contains_zero());  // v0 = -1/3
  CHECK_FALSE(kept("forest-ruth", "spring:k=3", "f32").contains_zero());
  // Exact for a while, and not for ever: 1/64 s of 8 m/s^2, in 11 bits.
  q.v0 = Rational(5, 2);
  b = budget(float_format("f16"), q, 100);
  REQUIRE(b.difference.reported.has_value());
  CHECK(*b.difference.reported > 1);
  CHECK(term(budget(float_format("f16"), q, *b.difference.reported - 1).lines[0], "rounding").is_zero());
  // The method's part does not depend on the format, and is -a h t / 2 for symplectic Euler.
  q = moving_body("symplectic-euler", "constant:a=-9", Rational(1, 50));
  for (const char* format : {"f16", "f32", "mpfr:40"}) {
    b = budget(float_format(format), q, 50);
    CHECK(term(b.lines[0], "method").contains(Rational(9, 2) / Rational(50)));
    CHECK(b.difference.reported == 1);
  }
  // Rounding shrinks with the format.
  double last = 1;
  for (const char* format : {"f16", "f32", "f64", "x87", "f128"}) {
    b = budget(float_format(format), moving_body("velocity-verlet", "spring:k=1", Rational(1, 10)), 200);
    const double rounding = std::abs(term(b.lines[0], "rounding").to_double());
    CHECK(rounding < last / 4);
    last = rounding;
  }
}

TEST_CASE("the bound of rounding looks at the start, too, where x and v may be largest") {
  FloatQuestion q = moving_body("symplectic-euler", "drag:a=0,c=9", Rational(1, 10));
  q.x0 = 0;
  q.v0 = 1000;
  const FloatFormat format = float_format("f32");
  for (int steps : {1, 2, 10}) {
    const Budget b = budget(format, q, steps);
    REQUIRE(b.rounding_bound.has_value());
    CHECK(*b.rounding_bound >= *rounding_bound(format, b.stored, steps, 0, 1000));
    CHECK(std::abs(term(b.lines[0], "rounding").to_double()) <= *b.rounding_bound);
  }
}

TEST_CASE("wide formats have parts with digits, too") {
  for (const char* format : {"f128", "mpfr:100", "mpfr:500"}) {
    CAPTURE(format);
    const FloatFormat f = float_format(format);
    const Rational unit = Rational(1, 2).pow(f.storage().precision);
    for (const Budget& b : {budget(f, moving_body("rk4", "spring:k=1", Rational(1, 10)), 50),
                            peak_budget(f, moving_body("rk4", "constant", Rational(1, 50)), Rational(17, 10),
                                        Rational(981, 100))}) {
      const Ball& rounding = term(b.lines[0], "rounding");
      REQUIRE(b.lines[0].closes());
      REQUIRE(rounding.significant(9).has_value());
      CHECK(rounding.midpoint().abs() < unit * Rational(100));
      CHECK(rounding.midpoint().abs() > unit / Rational(100));
    }
  }
}

TEST_CASE("runs that blow up say when, and too many steps are refused with a way out") {
  const Budget b =
      budget(float_format("f16"), moving_body("explicit-euler", "spring:k=100", Rational(1, 2)), 1000);
  REQUIRE(b.not_finite_at.has_value());
  CHECK(*b.not_finite_at < 20);
  CHECK(b.lines.empty());
  CHECK_THROWS_AS(budget(float_format("f32"), moving_body("explicit-euler", "spring:k=1", 1), 3'000'000'000),
                  Unable);
  CHECK_THROWS_AS(budget(float_format("f32"), moving_body("explicit-euler", "spring", 1), 10), BadInput);
  CHECK_THROWS_AS(budget(float_format("f32"), moving_body("explicit-euler", "spring:k=1", 1), 0), BadInput);
}
