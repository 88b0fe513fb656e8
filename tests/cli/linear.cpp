// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall derive` and `correct` for springs, dampers and drag, as a user meets them.
#include <doctest/doctest.h>

#include <cmath>

#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE(
    "an engine that keeps (1 - c)^t of a velocity with c of 1 and more: no logarithm, and no infinite "
    "numbers") {
  for (const char* arguments :
       {"derive bullet --param c=1 --force drag", "derive bullet --param c=2 --force spring",
        "derive bullet --param c=1 --force constant --steps 10", "spring bullet --param c=1 --k 4",
        "jump bullet --param c=1 --height 1", "jump bullet --param c=2 --height 1"}) {
    CAPTURE(arguments);
    const CommandRun o = run(arguments);
    CHECK(o.code == 4);
    CHECK(o.out.empty());
    CHECK(contains(o.error, "is no real number"));
  }
}

TEST_CASE("an oscillator: frequency, launch, energy") {
  const CommandRun o = run("derive velocity-verlet --force spring --ascii");
  CHECK(o.code == 0);
  CHECK(contains(o.text(), "k := -2*(C - 1)/h^2"));
  CHECK(contains(o.text(), "v^2 - 1/4*k^2*x^2*h^2 + k*x^2 is conserved exactly"));
  CHECK(contains(o.text(), "for k < 0: unstable physics"));
  CHECK(contains(run("derive explicit-euler --force spring --ascii").text(),
                 "v^2 + k*x^2, twice the energy, is multiplied by D = k*h^2 + 1"));
}

TEST_CASE("roots of equations come with their equations, their existence and numbers") {
  const CommandRun o = run("correct rk4 --force spring:k=4 --dt 1/10 --json");
  REQUIRE(o.code == 0);
  const auto json = nlohmann::json::parse(o.text());
  CHECK(json["equations"]["unknowns"].size() == 2);
  CHECK(json["equations"]["zero"].size() == 2);
  CHECK(json["notes"].size() == 1);
  CHECK(json["dt"] == "1/10");
  CHECK(json["numbers"][0]["target"] == "k");
  CHECK(json["numbers"][0]["terms"][0]["decimal"] == "4.00010515419693755859175346991");
  CHECK(json["obstruction"].is_null());
  const CommandRun text = run("correct rk4 --force spring --ascii");
  CHECK(
      contains(text.text(),
               "a stiffness alone does not exist: the determinant of the step is 1/576*y^4 - 1/72*y^3 + 1"));
  CHECK(contains(text.text(), "implicit function theorem"));
  CHECK(contains(text.text(), "k_new = k + 1/60*k^3*h^4 + higher powers of h"));
}

TEST_CASE("a kit that does not reach a step length says so") {
  const CommandRun o = run("correct rk4 --force drag:c=4 --dt 1/2");
  CHECK(o.code == 4);
  CHECK(contains(o.text(), "the least that the step can give is 0.270395"));
}

TEST_CASE("a force of time is corrected by its derivatives, spelled out in JSON" *
          doctest::test_suite("thorough")) {
  const auto json =
      nlohmann::json::parse(run("correct symplectic-euler --force poly:1+spring --json").text());
  bool force = false;
  for (const auto& c : json["corrections"])
    if (c["target"] == "f") force = contains(c["replace"], "f0 + f1*t");
  CHECK(force);
  CHECK(run("correct rk4 --force poly:13+spring").code == 4);
}

TEST_CASE("a damping that acts exactly is tuned by a force beside it: the kit's frames are the true ones") {
  const auto json =
      nlohmann::json::parse(run("correct chipmunk --force spring:k=4 --param c=1/5 --dt 1/10 --json").out);
  const auto number = [&](std::size_t i, std::size_t term) {
    return std::stod(json["numbers"][i]["terms"][term]["decimal"].get<std::string>());
  };
  // Chipmunk's loop, with a force -k x - c v of its old state; the truth is x'' = -4 x + log(4/5) v.
  const double k = number(0, 0), c = number(1, 0), h = 0.1, kept = std::pow(0.8, h), b = std::log(0.8) / 2;
  const double w = std::sqrt(4 - b * b), v0 = 0.3;
  double x = 1, v = number(2, 0) * x + number(2, 1) * v0;
  for (int n = 1; n <= 60; ++n) {
    const double f = -k * x - c * v;
    x += h * v;
    v = kept * v + h * f;
    const double t = n * h, truth = std::exp(b * t) * (std::cos(w * t) + (v0 - b) / w * std::sin(w * t));
    CHECK(x == doctest::Approx(truth).epsilon(1e-12));
  }
  CHECK(contains(run("correct chipmunk --force spring:k=4 --param c=1/5 --dt 1/10").text(),
                 "give the force a damping -c v with this c, and keep the integrator's own"));
}

TEST_CASE("numbers that take the force away leave what remains") {
  CHECK(contains(run("derive symplectic-euler --force damped-spring:k=0,c=0").text(),
                 "constant acceleration a"));
  // With numbers nothing is left, gravity neither.
  for (const std::string force : {"spring:k=0", "damped-spring:k=0,c=0"}) {
    CHECK(contains(run("derive symplectic-euler --dt 1/50 --steps 50 --v0 1 --force " + force).text(),
                   "x'' = 0,"));
    CHECK(contains(run("derive symplectic-euler --dt 1/50 --steps 50 --v0 1 --force " + force).text(),
                   "x_n  = 1 m   exact"));
    CHECK(contains(run("budget --steps 50 --v0 1 --x0 0 --formats f64 --force " + force).text(), "method"));
    CHECK(contains(run("cycle --formats f16 --x0 1 --force " + force).text(),
                   "after 0 steps it repeats itself every 1 steps"));
  }
  CHECK(contains(run("derive symplectic-euler --force damped-spring:k=0,c=1 --ascii").text(), "x'' = -v"));
  CHECK(contains(run("derive symplectic-euler --force damped-spring:k=4,c=0 --ascii").text(), "x'' = -4*x"));
  CHECK(contains(run("derive rk4 --force damped-spring:k=4,c=4").text(), "k = c^2/4, critically damped"));
}

}  // namespace
}  // namespace shortfall
