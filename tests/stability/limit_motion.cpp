// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/limit_motion.hpp"

#include <doctest/doctest.h>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/stability/stability.hpp"

using namespace shortfall;

namespace {

struct Expected {
  const char* name;
  const char* position;
  const char* velocity;
  Rational (*x)(int n, const Rational& x0, const Rational& v0, const Rational& h);
  Rational (*v)(int n, const Rational& x0, const Rational& v0, const Rational& h);
};

Rational sign(int n) { return n % 2 == 0 ? 1 : -1; }

}  // namespace

TEST_CASE("the four motions at h w = 2: formulas of the theory, and exact stepping") {
  const std::vector<Expected> all{
      {"symplectic-euler", "(-1)^n*((1 + 2*n)*x0 - n*h*v0)", "(-1)^n*(4*n*x0/h + (1 - 2*n)*v0)",
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * ((1 + 2 * Rational(n)) * x - n * h * v);
       },
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * (4 * n * x / h + (1 - 2 * Rational(n)) * v);
       }},
      {"symplectic-euler-drift-kick", "(-1)^n*((1 - 2*n)*x0 - n*h*v0)", "(-1)^n*(4*n*x0/h + (1 + 2*n)*v0)",
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * ((1 - 2 * Rational(n)) * x - n * h * v);
       },
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * (4 * n * x / h + (1 + 2 * Rational(n)) * v);
       }},
      {"velocity-verlet", "(-1)^n*(x0 - n*h*v0)", "(-1)^n*v0",
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * (x - n * h * v);
       },
       [](int n, const Rational&, const Rational& v, const Rational&) { return sign(n) * v; }},
      {"position-verlet", "(-1)^n*x0", "(-1)^n*(4*n*x0/h + v0)",
       [](int n, const Rational& x, const Rational&, const Rational&) { return sign(n) * x; },
       [](int n, const Rational& x, const Rational& v, const Rational& h) {
         return sign(n) * (v + 4 * n * x / h);
       }},
  };
  for (const Expected& e : all) {
    CAPTURE(e.name);
    const Program p = find_integrator(e.name);
    const auto motion = limit_motion(p, parameter_values(p), 1, 4);
    REQUIRE(motion);
    CHECK(motion->proved);
    CHECK(print(motion->position) == e.position);
    CHECK(print(motion->velocity) == e.velocity);
    // By stepping, which knows nothing of closed forms.
    const Rational h(1, 3), x0(7, 5), v0(-11, 4);
    const Tape tape = lower(p);
    // h w = 2 in exact arithmetic: h = 1/3, w^2 = 36.
    Numbers<Rational> problem{
        [](const Rational& x, const Rational&, const Rational&) { return x * Rational(-36); }};
    Run<Numbers<Rational>> run(tape, problem, h);
    run.begin(x0, v0, 0);
    for (int n = 1; n <= 200; ++n) {
      run.step();
      REQUIRE(run.state(0) == e.x(n, x0, v0, h));
      REQUIRE(run.state(1) == e.v(n, x0, v0, h));
    }
  }
}

TEST_CASE("which starting values do not grow at the limit") {
  const auto growth = [](const char* name) {
    const Program p = find_integrator(name);
    const auto motion = limit_motion(p, parameter_values(p), 1, 4);
    REQUIRE(motion);
    return print(motion->position_growth) + " | " + print(motion->velocity_growth);
  };
  CHECK(growth("symplectic-euler") == "2*x0 - h*v0 | 2*x0 - h*v0");
  CHECK(growth("symplectic-euler-drift-kick") == "2*x0 + h*v0 | 2*x0 + h*v0");
  CHECK(growth("velocity-verlet") == "v0 | 0");
  CHECK(growth("position-verlet") == "0 | x0");
}

TEST_CASE("no formula where the eigenvalues are not rational: the classical method at 2 sqrt(2)") {
  const Program p = find_integrator("rk4");
  CHECK_FALSE(limit_motion(p, parameter_values(p), 1, 8));
  const Stability s = stability(p);
  REQUIRE(s.at_limit);
  CHECK(s.at_limit->bounded());
  CHECK(s.at_limit->circle.front().cosine == Rational(-1, 3));
}

TEST_CASE("four substeps move the limit to 8, where the frame's eigenvalue is +1") {
  const Stability s = stability(find_integrator("velocity-verlet"), {}, 4);
  REQUIRE(s.limit());
  CHECK(s.limit()->rational() == Rational(8));
  REQUIRE(s.limit_motion);
  CHECK(s.limit_motion->proved);
  // Of the substep's h/4: x_n = (-1)^(4 n) (x0 - 4 n (h/4) v0).
  CHECK(print(s.limit_motion->position) == "x0 - n*h*v0");
}
