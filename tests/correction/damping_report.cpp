// SPDX-License-Identifier: GPL-3.0-or-later
// Reports held against plain stepping in binary64 and the values that the engines' maps give by hand.
#include "analysis/correction/damping_report.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/spring_report.hpp"
#include "analysis/motion/ball_formula.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"

using namespace shortfall;

namespace {

DampingReport report(const std::string& engine, const Rational& c, const Rational& h) {
  return damping_report(find_integrator(engine), {{"c", c}}, h, Rational(981, 100));
}

bool near(const Ball& ball, double value) {
  return std::abs(ball.to_double() - value) < 1e-9 * (1 + std::abs(value));
}

}  // namespace

TEST_CASE("terminal speeds of engines: g (1 - c dt)/c, g/c, g (1 + c h)/c, and 14.25 m/s or so for powers") {
  const Rational h(1, 60), c(1, 2);
  const double g = 9.81, dt = 1 / 60.0;
  for (const char* engine : {"physx", "jolt"})
    CHECK(near(report(engine, c, h).here.terminal, g * (1 - 0.5 * dt) / 0.5));
  for (const char* engine : {"godot", "box2d-2", "rapier", "planck"})
    CHECK(near(report(engine, c, h).here.terminal, g / 0.5));
  CHECK(near(report("box2d", c, h).here.terminal, g * (1 + 0.5 * dt / 4) / 0.5));
  for (const char* engine : {"bullet", "cannon-es", "p2", "chipmunk"}) {
    const DampingReport r = report(engine, c, h);
    CHECK(near(r.here.terminal, g * dt / (1 - std::pow(0.5, dt))));
    CHECK(r.here.terminal.to_double() == doctest::Approx(14.25).epsilon(0.002));
    CHECK(near(r.here.kept, 0.5));  // whatever the rate
    for (const DampingAtRate& rate : r.rates) CHECK(near(rate.kept, 0.5));
  }
}

TEST_CASE("what is left after a second and how far a body coasts: by plain stepping") {
  for (const int hertz : {30, 60, 144}) {
    const double dt = 1.0 / hertz, c = 0.8, g = 9.81;
    double v = 1, x = 0, fall = 0;
    double kept = 0;
    for (int n = 1; n <= 60 * hertz; ++n) {
      v = v * (1 - c * dt);
      x += dt * v;
      fall = (fall + g * dt) * (1 - c * dt);
      if (n == hertz) kept = v;
    }
    const DampingReport r = report("physx", Rational(4, 5), Rational(1, hertz));
    CHECK(near(r.here.kept, kept));
    CHECK(near(r.here.coast, x));
    CHECK(near(r.here.terminal, fall));
    CHECK(near(*r.here.rate, -std::log(1 - c * dt) * hertz));
    CHECK(near(*r.true_rate, c));
  }
}

TEST_CASE("damping numbers convert between all conventions and back") {
  const int bits = 300;
  for (int i = 0; i < kDampingConventions; ++i)
    for (int j = 0; j < kDampingConventions; ++j)
      for (const Rational& c : {Rational(1, 2), Rational(3, 10), Rational(1, 100)}) {
        const auto from = static_cast<DampingConvention>(i), to = static_cast<DampingConvention>(j);
        CAPTURE(name_of(from));
        CAPTURE(name_of(to));
        const Ball h(Rational(1, 60), bits), number(c, bits);
        const auto value = [&](const Expr& e, const Ball& at) {
          return ball_value(e, {{"c", at}, {"h", h}, {"s", at}}, bits);
        };
        const Ball converted = value(converted_damping(from, to), number);
        const auto same = [&](const Ball& a, const Ball& b) {
          return a.overlaps(b) && (abs(a - b) - Ball(Rational::parse("1e-70"), bits)).sign() == -1;
        };
        // The share is the same, the way back leads back, and both agree with the way over the share.
        CHECK(same(value(share_of(from), number), value(share_of(to), converted)));
        CHECK(same(value(converted_damping(to, from), converted), number));
        CHECK(same(value(damping_from_share(to), value(share_of(from), number)), converted));
      }
}

TEST_CASE("damping times frame time of 1 and more: told, and the step's own numbers are given") {
  const DampingReport r = report("godot", 60, Rational(1, 50));
  CHECK_FALSE(r.assumed_hold);
  CHECK(r.here.share.is_zero());
  CHECK_FALSE(r.here.rate);
  CHECK_THROWS_AS(report("godot", -1, Rational(1, 50)), BadInput);
  CHECK_THROWS_AS(report("godot", 0, Rational(1, 50)), BadInput);
  CHECK_THROWS_AS(report("bullet", 2, Rational(1, 50)), BadInput);
  CHECK_THROWS_AS(damping_report(find_integrator("rk4"), {}, Rational(1, 50), Rational(981, 100)), BadInput);
}

TEST_CASE("a force held over N substeps: det = 1 + (1 - (N+1)/(2N)) w, unstable for N > 1") {
  for (const int substeps : {2, 4, 8}) {
    SpringQuestion q{40, 0, false, Rational(1, 60), substeps, true, {}};
    const SpringReport r = spring_report(find_integrator("symplectic-euler"), q);
    const double w = 40.0 / 3600, n = substeps;
    CHECK(near(r.effective.determinant, 1 + (1 - (n + 1) / (2 * n)) * w));
    CHECK(r.effective.stable == false);
    // By plain stepping: amplitudes 5 s apart, from the quadratic form that the step multiplies by its
    // determinant.
    double x = 1, v = 0;
    const auto frame = [&] {
      const double a = -40 * x;
      for (int i = 0; i < substeps; ++i) {
        v += a / (60 * n);
        x += v / (60 * n);
      }
    };
    const auto size = [&] {  // M^T Q M = det Q, with M from two unit states
      const double t = r.effective.trace.to_double(), m22 = 1, m21 = -40.0 / 60, m12 = 1 / 60.0;
      const double m11 = t - m22;
      return -m21 / m12 * x * x + (m11 - m22) / m12 * x * v + v * v;
    };
    const double before = size();
    for (int i = 0; i < 60; ++i) frame();
    CHECK(std::sqrt(size() / before) == doctest::Approx(r.effective.growth.to_double()).epsilon(1e-9));
  }
}

TEST_CASE(
    "springs at a tick rate: symplectic Euler keeps its amplitude, implicit Euler's undamped spring dies") {
  SpringQuestion q;
  set_spring(q, 2, 0);
  const SpringReport kept = spring_report(find_integrator("symplectic-euler"), q);
  CHECK(kept.effective.stable == true);
  const double w = 2 * 2 * std::acos(-1.0) / 60;  // z = w h
  CHECK(near(*kept.effective.frequency, 2 * std::asin(w / 2) * 60 / (2 * std::acos(-1.0))));
  CHECK(near(*kept.truth.frequency, 2));
  CHECK(kept.effective.determinant.contains(1));
  const SpringReport dies = spring_report(find_integrator("implicit-euler"), q);
  CHECK(near(dies.effective.determinant, 1 / (1 + w * w)));
  CHECK(near(dies.effective.growth, std::pow(1 + w * w, -30.0)));
  CHECK(dies.effective.damping_ratio->sign() == 1);
  set_spring(q, 2, Rational(1, 4));
  CHECK(near(*spring_report(find_integrator("symplectic-euler"), q).truth.damping_ratio, 0.25));
  CHECK(spring_report(find_integrator("velocity-verlet"), {16000, 0, false, Rational(1, 60), 1, false, {}})
            .effective.stable == false);
}

TEST_CASE("a spring exactly at its limit, and one that is exactly critical") {
  const auto of = [](const char* integrator, const Rational& k, const Rational& c, const Rational& h) {
    return spring_report(find_integrator(integrator), {k, c, false, h, 1, false, {}});
  };
  // w h = 2: the eigenvalue -1 twice, and its one eigenvector; amplitudes grow by the same amount each frame.
  for (const char* integrator : {"symplectic-euler", "velocity-verlet"}) {
    const SpringReport limit = of(integrator, 10000, 0, Rational(1, 50));
    CHECK_FALSE(limit.effective.oscillates);
    CHECK(limit.effective.stable == false);
    CHECK(limit.effective.growth.contains(1));
    CHECK(limit.truth.oscillates);
    CHECK(near(*limit.truth.frequency, 100 / (2 * std::acos(-1.0))));
    CHECK(of(integrator, 9999, 0, Rational(1, 50)).effective.stable == true);
    CHECK(of(integrator, 10001, 0, Rational(1, 50)).effective.stable == false);
  }
  // c = 2 w: the truth has one eigenvalue exp(-w h) twice.
  const SpringReport critical = of("symplectic-euler", 1, 2, Rational(1, 2));
  CHECK_FALSE(critical.truth.oscillates);
  CHECK(critical.truth.stable == true);
  CHECK(near(critical.truth.growth, std::exp(-1.0)));
  CHECK(critical.effective.stable == true);
  CHECK(near(critical.effective.growth, 0.5625));  // eigenvalues 0 and 3/4, two frames a second
  // ... and with h = 1 the step has -1/2 +- sqrt(5)/2.
  CHECK(of("symplectic-euler", 1, 2, 1).effective.stable == false);
  // The eigenvalues 0 and -1: one of size 1, once, so that the motion stays bounded.
  CHECK(of("symplectic-euler", 2, 1, 1).effective.stable == true);
}

TEST_CASE("the true spring of an engine that damps by a power has the logarithm as its damping") {
  SpringQuestion q;
  q.k = 40;
  q.h = Rational(1, 60);
  q.parameters = {{"c", Rational(1, 10)}};
  for (const char* engine : {"bullet", "cannon-es", "p2"}) {
    CAPTURE(engine);
    const SpringReport r = spring_report(find_integrator(engine), q);
    REQUIRE(r.truth.damping_ratio);
    CHECK(r.truth.damping_ratio->to_double() ==
          doctest::Approx(-std::log(0.9) / (2 * std::sqrt(40.0))).epsilon(1e-12));
  }
}

TEST_CASE("springs that are none are refused") {
  const Program p = find_integrator("symplectic-euler");
  CHECK_THROWS_AS(spring_report(p, {-1, 0, false, Rational(1, 60), 1, false, {}}), BadInput);
  CHECK_THROWS_AS(spring_report(p, {1, -1, false, Rational(1, 60), 1, false, {}}), BadInput);
  CHECK_THROWS_AS(
      spring_report(find_integrator("godot"), {1, 1, false, Rational(1, 60), 1, false, {{"c", 1}}}),
      BadInput);
}
