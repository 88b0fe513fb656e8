// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/claims.hpp"
#include "analysis/stability/stability_claims.hpp"

#include <doctest/doctest.h>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/tape.hpp"

using namespace shortfall;

namespace {

ClaimVerdict verdict(const std::string& step, const std::string& claim) {
  const auto verdicts =
      claims(parse("integrator test\n" + step + "\nexpect\n  " + claim + "\n", "test.integrator"));
  REQUIRE(verdicts.size() == 1);
  return verdicts[0];
}

const std::string kSymplecticEuler = "step\n  v = v + h*a(x, v, t)\n  x = x + h*v";
const std::string kRk4 = "tableau\n 0 |\n 1/2 | 1/2\n 1/2 | 0 1/2\n 1 | 0 0 1\n b | 1/6 1/3 1/3 1/6";

}  // namespace

TEST_CASE(
    "every integrator of the catalogue is described, names its source and makes claims, and every claim is "
    "proved" *
    doctest::test_suite("thorough")) {
  CHECK(catalogue().size() >= 27);
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    CHECK_FALSE(program.description.empty());
    CHECK_FALSE(program.sources.empty());
    CHECK(program.claims.size() >= 2);
    const std::vector<ClaimVerdict> verdicts = all_claims(program);
    CHECK(verdicts.size() == program.claims.size());
    for (const ClaimVerdict& v : verdicts) {
      CAPTURE(v.claim);
      CAPTURE(v.found);
      CHECK(v.holds);
    }
  }
}

TEST_CASE("the closed forms behind the claims agree with stepping in letters") {
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    const StepMap map = step_map(lower(program), 0);
    CHECK(prove(map, closed_form(map)).proved);
  }
}

TEST_CASE("a claim of a shortfall holds in any form in which it is written") {
  for (const char* claim : {"shortfall -a*h*t/2", "shortfall -1/2*n*h^2*a", "shortfall -(a*h)*t/2 + 0*x0",
                            "shortfall -a*t^2/(2*n)", "shortfall 3*v0*t - 6*v0*n*h/2 - a*t*(h/2)",
                            "shortfall -2^n*a*h*t/2^(n + 1)", "shortfall -4^n*2^(-2*n)*a*h*t/2",
                            "shortfall-velocity 0", "shortfall-velocity a*h - h*a"}) {
    CAPTURE(claim);
    CHECK(verdict(kSymplecticEuler, claim).holds);
  }
}

TEST_CASE("a wrong claim is refuted, and what is true is said") {
  CHECK(verdict(kSymplecticEuler, "shortfall a*h*t/2").found == "shortfall -1/2*a*h*t");
  for (const char* claim :
       {"shortfall a*h*t/2", "shortfall 0", "shortfall -a*h^2/2", "shortfall -a*h*t/2 + 0.001*x0",
        "shortfall -a*h*t/2 + h*v0/1000000", "shortfall -a*h*t/2*2^n", "shortfall-velocity a*h"}) {
    CAPTURE(claim);
    CHECK_FALSE(verdict(kSymplecticEuler, claim).holds);
  }
  CHECK(verdict(kRk4, "exact 2").holds);
  CHECK_FALSE(verdict(kRk4, "exact 1").holds);
  CHECK(verdict(kRk4, "exact 1").found == "exact 2 or more");
  CHECK_FALSE(verdict(kRk4, "exact 3").holds);
  CHECK(verdict(kRk4, "exact 3").found == "exact 2");
  CHECK_FALSE(verdict(kSymplecticEuler, "exact 0").holds);
  CHECK(verdict(kSymplecticEuler, "exact 0").found == "not exact for a constant force");
}

TEST_CASE("a step that loses the initial velocity is exact for no force") {
  CHECK(verdict("step\n  x = x + h*v/2\n  v = v + h*a(x, v, t)", "exact 0").found ==
        "not exact for a constant force");
}

TEST_CASE("a claim may contain parameters, also those that follow from others") {
  const std::string theta =
      "param theta = 1/2\n param half = theta/2\nstep\n  x = x + h*v + theta*h^2*a(x, v, t)\n  v = v + "
      "h*a(x, v, t)";
  CHECK(verdict(theta, "shortfall (1/2 - theta)*a*h*t").holds);
  CHECK(verdict(theta, "shortfall (1/2 - 2*half)*a*h*t").holds);
  CHECK_FALSE(verdict(theta, "shortfall 0").holds);
}

TEST_CASE("a damped step's shortfall is claimed with powers of its factor") {
  // v <- r v, x <- x + h v: x_n = x0 + h v0 (r + ... + r^n).
  const std::string damped = "param r = 1/2\nstep\n  v = r*v\n  x = x + h*v";
  CHECK(verdict(damped, "shortfall v0*t - h*v0*r*(1 - r^n)/(1 - r) + a*t^2/2").holds);
  CHECK(verdict(damped, "shortfall-velocity v0 - r^n*v0 + a*t").holds);
  CHECK_FALSE(verdict(damped, "shortfall-velocity v0 - r^(n + 1)*v0 + a*t").holds);
}

TEST_CASE("a step with irrational eigenvalues oscillates, which no claim says") {
  // x_next = 3 x - x_prev grows like powers of the golden ratio; x0 alone excites it.
  const std::string golden =
      "state x_prev : L\nstart\n  x_prev = x\nstep\n  x_next = 3*x - x_prev\n  x_prev = x\n  x = x_next";
  CHECK(verdict(golden, "shortfall v0*t + a*t^2/2 + x0").found ==
        "shortfall x0 + v0*t + 1/2*a*t^2 and an oscillation");
  CHECK_FALSE(verdict(golden, "shortfall v0*t + a*t^2/2 + x0").holds);
  CHECK(verdict(golden, "shortfall-velocity a*t").holds);
  CHECK_FALSE(verdict(golden, "exact 0").holds);
}

TEST_CASE("a claim that fails in the first step only is refuted") {
  // The carried y is x0 until the first step is done; from then on it is 0.
  const std::string settling =
      "state y : L\nstart\n  y = h*v\nstep\n  x = x + h*v + h^2/2*a(x, v, t)\n  v = v + h*a(x, v, t)\n  y = "
      "0*h*v\n"
      "finish\n  x = x + y";
  CHECK(verdict(settling, "shortfall 0").holds);
  const std::string late =
      "state y : L\n state z : L\nstart\n  y = h*v\n  z = h*v\nstep\n  x = x + h*v + h^2/2*a(x, v, t)\n"
      "  v = v + h*a(x, v, t)\n  y = z\n  z = 0*h*v\nfinish\n  x = x + y";
  CHECK_FALSE(verdict(late, "shortfall 0").holds);
  CHECK_FALSE(verdict(late, "exact 0").holds);
}
