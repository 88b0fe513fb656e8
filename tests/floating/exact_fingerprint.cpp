// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_fingerprint.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/exact_first_frames.hpp"
#include "analysis/floating/exact_trajectory.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/motion/numeric_stepping.hpp"

using namespace shortfall;
using namespace shortfall::numeric;

TEST_CASE("fingerprints are those of the exact trajectory, by stepping and by squaring") {
  for (const char* integrator :
       {"symplectic-euler", "velocity-verlet", "rk4", "adams-bashforth-2", "newmark"})
    for (const char* force :
         {"constant:a=-9", "spring:k=3", "poly:3:f0=1,f1=-2,f2=1/3,f3=5+damped-spring:k=0,c=1/7"}) {
      CAPTURE(integrator);
      CAPTURE(force);
      const Program program = find_integrator(integrator);
      const NumericQuestion q = question(force, "1/9", "0");
      ExactTrajectory exact(program, q);
      ExactFingerprint stepped(program, q), jumped(program, q);
      for (const std::int64_t steps : {0, 1, 7, 100}) {
        exact.advance(steps);
        stepped.advance(steps);
        jumped.jump(steps);
        CHECK(stepped.frame() == exact.frame());
        for (const ExactFingerprint* f : {&stepped, &jumped}) {
          CHECK(f->position() == exact.position().fingerprint());
          CHECK(f->velocity() == exact.velocity().fingerprint());
        }
      }
    }
}

TEST_CASE("a closed form is checked against a million steps, and a wrong one fails") {
  const NumericQuestion q = question("constant:a=-9.81", "1/50", "0");
  ExactFingerprint f(find_integrator("symplectic-euler"), q);
  f.advance(1'000'000);
  const Modular a(Rational::parse("-9.81")), x0(q.x0), v0(q.v0), h(q.h);
  const Modular t = Modular(1'000'000) * h;
  CHECK(f.position() == x0 + v0 * t + a * t * (t + h) / Modular(2));
  CHECK(f.position() != x0 + v0 * t + a * t * t / Modular(2));
}

TEST_CASE("10^18 steps by squaring agree with the closed form") {
  const NumericQuestion q = question("constant:a=-9.81", "1/50", "0");
  ExactFingerprint f(find_integrator("velocity-verlet"), q);
  f.jump(1'000'000'000'000'000'000);
  const Modular t = Modular(1'000'000'000'000'000'000) * Modular(q.h);
  CHECK(f.position() ==
        Modular(q.x0) + Modular(q.v0) * t + Modular(Rational::parse("-9.81")) * t * t / Modular(2));
  CHECK_THROWS_AS(f.jump(-1), BadInput);
}

TEST_CASE("under a pendulum's cubic force digits multiply, and ten frames are the limit unless asked") {
  ExactFirstFrames q;
  q.force = [](const Rational& x, const Rational&, const Rational&) { return x * x * x / 6 - x; };
  q.h = Rational(1, 10);
  q.x0 = 1;
  const Program program = find_integrator("symplectic-euler");
  const auto frames = exact_first_frames(program, q, 6);
  CHECK(frames.size() == 7);
  CHECK(frames[1].first == Rational(1) - Rational(5, 6) / 100);
  CHECK(frames[6].first.digits() > 2 * frames[5].first.digits());
  CHECK_THROWS_WITH_AS(exact_first_frames(program, q, 11), doctest::Contains("10 frames are the limit"),
                       Unable);
  q.most_frames = 20;
  q.most_digits = 30'000;
  CHECK_THROWS_WITH_AS(exact_first_frames(program, q, 20), doctest::Contains("which is the limit"), Unable);
  CHECK_THROWS_WITH_AS(exact_first_frames(find_integrator("implicit-midpoint"), q, 3),
                       doctest::Contains("not affine"), Unable);
}
