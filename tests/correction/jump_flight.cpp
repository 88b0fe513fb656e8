// SPDX-License-Identifier: GPL-3.0-or-later
// Flights that are no parabola, or not from the first frame on: integrators that a user might write.
#include <doctest/doctest.h>

#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {
namespace {

Program written(const std::string& head, const std::string& step) {
  return parse("integrator test\n" + head + "\nstep\n" + step + "\n", "test.integrator");
}

TEST_CASE(
    "with a damping that acts, frames are stepped exactly and the launch correction is shown not to exist") {
  const Program damped =
      written("  param c : 1/T = 1/10", "  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v");
  const Jump j = jump(damped, {.height = Rational(17, 10)});
  // By hand: s_1 = dt (u - g dt)(1 - c dt).
  const Flight flight(damped, Rational(1, 50));
  CHECK_FALSE(flight.parabolic());
  CHECK(flight.rise(1) == Rational(1, 50) * Rational(499, 500));
  CHECK(flight.fall(1) == Rational(1, 2500) * Rational(499, 500));
  CHECK(j.shortfall.total == j.shortfall.method + j.shortfall.sampling);
  CHECK(j.best_frame.n == 28);
  CHECK_FALSE(j.correction.exists);
  CHECK(j.correction.reason.find("what is missing depends on the launch") != std::string::npos);
  CHECK_FALSE(j.corrected);
  CHECK_FALSE(j.ideal_time_height);
  REQUIRE(j.on_frame);
  CHECK(j.on_frame->top.height == Surd(j.target));
  CHECK(flight.height(j.on_frame->launch, j.g, j.on_frame->top.n) == Surd(j.target));
  REQUIRE(j.binary32);
  CHECK(j.binary32->miss.abs() <= 3);
}

TEST_CASE("damped fully out, it is a parabola again") {
  const Program damped =
      written("  param c : 1/T = 1/10", "  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v");
  const Jump j = jump(damped, {.height = Rational(2, 5), .parameters = {{"c", 0}}});
  CHECK(j.correction.exists);
  CHECK(j.correction.value(j.g) == Rational(981, 10'000));
  CHECK((j.shortfall.total * Surd(100)).decimal(9) == "2.762010199");
}

TEST_CASE("the correction is a formula in the integrator's parameters") {
  const Program theta = written("  param theta = 1/4",
                                "  v0 = v\n  v = v + h*a(x, v, t)\n  x = x + h*((1 - theta)*v0 + theta*v)");
  const Jump k = jump(theta, {.height = Rational(2, 5)});
  REQUIRE(k.correction.exists);
  CHECK(k.correction.value(k.g) == Rational(-1, 4) * k.g * k.dt);
  const Expr at_half =
      replace(replace(k.correction.formula, "theta", number(Rational(1, 2))), "g", number(1));
  CHECK(mentions(k.correction.formula, "theta"));
  CHECK_FALSE(mentions(at_half, "theta"));
  CHECK(
      jump(theta, {.height = 1, .parameters = {{"theta", Rational(1, 2)}}}).correction.per_gravity.is_zero());
}

TEST_CASE("an integrator that feels half of gravity has no launch correction, and two frames prove it") {
  const Jump j = jump(written("", "  v = v + h/2*a(x, v, t)\n  x = x + h*v"), {.height = 1});
  CHECK_FALSE(j.correction.exists);
  CHECK(j.correction.reason.find("no velocity serves both") != std::string::npos);
  CHECK(j.shortfall.total.sign() < 0);
  REQUIRE(j.on_frame);
  CHECK(j.on_frame->top.height == Surd(1));
}

TEST_CASE("a body that never comes down is said not to") {
  CHECK_THROWS_AS(jump(written("", "  x = x + h*v"), {.height = 1}), Unable);
}

TEST_CASE("a first frame of its own is taken into account") {
  // The first drift uses a velocity that was never set: the body stays where it is in frame 1, then moves as
  // usual.
  const Program late = parse(
      "integrator test\n  state w : L/T\nstart\n  w = 0*v\nstep\n  x = x + h*w\n  v = v + h*a(x, v, t)\n  w "
      "= v\n",
      "test");
  const Flight flight(late, Rational(1, 50));
  CHECK(flight.rise(1).is_zero());
  CHECK(flight.rise(2) == Rational(1, 50));
  const Jump j = jump(flight, Rational(2, 5), Rational(981, 100));
  CHECK_FALSE(j.correction.exists);
  CHECK(j.on_frame->top.height == Surd(Rational(2, 5)));
}

TEST_CASE("heights, steps and gravities that are not positive are refused") {
  const Program program = find_integrator("symplectic-euler");
  CHECK_THROWS_AS(jump(program, {.height = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = -1}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .dt = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .dt = Rational(-1, 50)}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .g = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .substeps = 0}), BadInput);
  CHECK_THROWS_AS(jump(program, {.height = 1, .parameters = {{"beta", 1}}}), BadInput);
}

}  // namespace
}  // namespace shortfall
