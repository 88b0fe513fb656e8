// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/first_difference.hpp"

#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/floating/float_question.hpp"

using namespace shortfall;

using testing::resting_body;

namespace {

FirstDifference difference(const std::string& format, const FloatQuestion& q, int most = 1000) {
  const FloatFormat f = float_format(format);
  return first_difference(f, q, stored(q, f), most);
}

const char* const kEuler =
    "# drift last\n"
    "integrator mine\n"
    "\n"
    "step\n"
    "  v = v + h*a(x, v, t)\n"
    "  x = x + h*v\n";

}  // namespace

TEST_CASE("the statement that rounds first, beside the same step rounded by hand") {
  // Dyadic numbers, so that nothing is rounded at first. In 11 bits v = 5/2 - n/8 stays exact for long; x, in
  // units of 1/512, does not once it is beyond 4.
  FloatQuestion q = resting_body(parse(kEuler, "mine.integrator"), "constant:a=-8", Rational(1, 64));
  q.v0 = Rational(5, 2);
  Rational x = 1, v = Rational(5, 2);
  int step = 0;
  std::string statement;
  while (statement.empty()) {
    ++step;
    v += Rational(-8, 64);
    if (*rounded(v, BinaryFormat::binary16()) != v) statement = "v = v + h*a(x, v, t)";
    x += v / Rational(64);
    if (statement.empty() && *rounded(x, BinaryFormat::binary16()) != x) statement = "x = x + h*v";
  }
  const FirstDifference d = difference("f16", q);
  REQUIRE(d.rounding.has_value());
  CHECK(step > 10);
  CHECK(d.rounding->step == step);
  CHECK(d.rounding->statement == statement);
  CHECK(d.rounding->line == 6);
  CHECK(d.reported == step);
  CHECK(d.compared == step);
  // In 24 bits it takes longer than anybody asked for.
  CHECK_FALSE(difference("f32", q, 100).rounding.has_value());
  CHECK(difference("f32", q, 100).compared == 100);
  // A spring of k = 1/3 is rounded in the force's own line.
  q.force = force_named("spring:k=3");
  q.x0 = Rational(1, 3);
  q.v0 = 0;
  const FirstDifference spring = difference("f32", q);
  CHECK(spring.rounding->step == 1);
  CHECK(spring.rounding->line == 5);
  CHECK(spring.rounding->statement == "v = v + h*a(x, v, t)");
}

TEST_CASE("start, substeps, stages and what is reported have their statements, too") {
  FloatQuestion q = resting_body("velocity-verlet", "spring:k=3", Rational(1, 64));
  q.x0 = Rational(1, 3);
  FirstDifference d = difference("f32", q);
  CHECK(d.rounding->step == 0);
  CHECK(d.rounding->statement == "a0 = a(x, v, t)");
  CHECK(d.rounding->line > 0);
  CHECK(d.reported >= 1);
  // In a third of a frame the step itself is rounded; what is made with it first is named.
  q = resting_body(parse(kEuler, "mine.integrator"), "constant:a=-8", Rational(1, 64));
  q.substeps = 3;
  d = difference("f32", q);
  CHECK(d.rounding->step == 1);
  CHECK(d.rounding->line == 5);
  // A tableau's statements stand where it does.
  d = difference("f32", resting_body("rk4", "spring:k=1", Rational(1, 10)));
  CHECK(d.rounding->step == 1);
  CHECK(d.rounding->line > 0);
  CHECK(!d.rounding->statement.empty());
  // An unknown of a solve.
  d = difference("f64", resting_body("implicit-midpoint", "spring:k=1", Rational(1, 10)));
  CHECK(d.rounding->step == 1);
  CHECK(!d.rounding->statement.empty());
  // Irrational coefficients have no exact run.
  CHECK_THROWS_AS(difference("mpfr:20", resting_body(parse("integrator odd\nstep\n  x = x + sqrt(2)*h*v\n",
                                                           "odd.integrator"),
                                                     "spring:k=1", 1)),
                  Unable);
}
