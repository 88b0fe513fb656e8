// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/drag.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "analysis/problems/letters.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

Drag drag_of(const char* name) {
  const Program p = find_integrator(name);
  return drag(amplification(p, parameter_values(p), Damping::viscous));
}

/// What one step multiplies a velocity by under x'' = -c v, by running it in binary64.
double stepped_factor(const Program& p, double d) {
  const Tape tape = lower(p, parameter_values(p));
  Numbers<double> problem{[&](const double&, const double& v, const double&) { return -d * v; }};
  Run<Numbers<double>> run(tape, problem, 1.0);
  run.begin(0, 0, 0);
  run.set_state(1, 1);  // after `start`, which may give a first half kick
  run.step();
  return run.state(1);
}

}  // namespace

TEST_CASE("symplectic Euler under drag: turns round from c h = 1 on, is lost beyond c h = 2") {
  const Drag d = drag_of("symplectic-euler");
  REQUIRE(d.factor);
  CHECK(*d.factor == Fraction(1) - Fraction::letter(kDamping));
  REQUIRE(d.reversals.size() == 1);
  CHECK(d.reversals[0].from.rational() == Rational(1));
  CHECK_FALSE(d.reversals[0].to);
  REQUIRE(d.windows.limit());
  CHECK(d.windows.limit()->at.rational() == Rational(2));
  CHECK(d.windows.windows[0].to_included);  // the velocity alternates, it does not grow
}

TEST_CASE(
    "implicit Euler never turns round and is never lost; the trapezoidal rule turns round from c h = 2 on") {
  CHECK(drag_of("implicit-euler").reversals.empty());
  CHECK(drag_of("implicit-euler").windows.always());
  REQUIRE(drag_of("trapezoidal").reversals.size() == 1);
  CHECK(drag_of("trapezoidal").reversals[0].from.rational() == Rational(2));
  CHECK(drag_of("trapezoidal").windows.always());
}

TEST_CASE("the factor and its signs agree with one step of every integrator, in binary64") {
  int compared = 0;
  for (const Program& p : testing::undamped_catalogue()) {
    const Amplification damped = amplification(p, parameter_values(p), Damping::viscous);
    if (!damped.algebraic.empty()) continue;  // irrational numbers have tests of their own
    const Drag d = drag(damped);
    if (!d.factor) continue;
    CAPTURE(p.name);
    // Carried accelerations and the like have no meaning for a velocity that starts alone.
    if (!p.states.empty()) continue;
    for (int i = 1; i <= 60; ++i) {
      const Rational at(i, 8);
      CAPTURE(at.str());
      const double expected = stepped_factor(p, at.to_double());
      CHECK(d.factor->evaluate({{kDamping, at}}).to_double() == doctest::Approx(expected).epsilon(1e-9));
      bool turns = false;
      for (const Drag::Reversal& r : d.reversals)
        turns = turns || (r.from.compare(at) < 0 && (!r.to || r.to->compare(at) > 0));
      if (std::abs(expected) > 1e-9) CHECK(turns == (expected < 0));
      ++compared;
    }
  }
  CHECK(compared > 500);
}

TEST_CASE("the unstable case k < 0: the motion runs away, and most steps with it, as is right") {
  CHECK(stability(find_integrator("symplectic-euler")).runaway.windows.empty());
  CHECK(stability(find_integrator("rk4")).runaway.windows.empty());
  // Implicit Euler multiplies by 1/(1 - s) and 1/(1 + s): it wrongly settles for s > 2, and has no step at s
  // = 1.
  const Windows settled = stability(find_integrator("implicit-euler")).runaway;
  REQUIRE(settled.windows.size() == 1);
  CHECK(settled.windows[0].from->at.rational() == Rational(2));
  CHECK(settled.windows[0].from_included);
  CHECK_FALSE(settled.windows[0].to);
}
