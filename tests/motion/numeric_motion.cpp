// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/numeric_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "analysis/motion/ball_flow.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "tests/motion/numeric_stepping.hpp"

using namespace shortfall;
using namespace shortfall::numeric;

TEST_CASE("10^18 steps of an oscillation have the digits of cos(n theta), which MPFR computes") {
  // velocity Verlet: x_n = x0 cos(n theta) + v0 h sin(n theta)/sin(theta) with cos(theta) = 1 - h^2 k/2.
  const Precision precision(150);
  const NumericQuestion q = question("spring:k=3", "1/7", "1e18");
  const NumericMotion m = numeric_motion(find_integrator("velocity-verlet"), q);
  const Real n = real(Rational(10).pow(18), 150);
  const Real theta = acos(real(Rational(1) - Rational(3, 98), 150));
  const Real x =
      real(q.x0, 150) * cos(Real(n * theta)) + real(q.v0 / 7, 150) * sin(Real(n * theta)) / sin(theta);
  CHECK(near(shown(m.position), Rational::parse(x.str(60, std::ios_base::scientific)), 49));
  // ... and the true motion those of cos(w t).
  const Real w = sqrt(real(Rational(3), 150));
  const Real t = n / 7;
  const Real truth = real(q.x0, 150) * cos(Real(w * t)) + real(q.v0, 150) * sin(Real(w * t)) / w;
  CHECK(near(shown(m.exact_position), Rational::parse(truth.str(60, std::ios_base::scientific)), 49));
  CHECK(near(shown(m.position_shortfall), Rational::parse(Real(truth - x).str(60, std::ios_base::scientific)),
             48));
  CHECK(m.position_shortfall.ball.sign() == Real(truth - x).sign());
}

TEST_CASE("far along, symplectic Euler still conserves its quadratic form, exactly") {
  const NumericQuestion q = question("spring:k=2", "1/3", "1e18");
  const NumericMotion m = numeric_motion(find_integrator("symplectic-euler"), q);
  const auto form = [&](const Ball& x, const Ball& v) {
    const Ball k(2, 64), h(q.h, 400);
    return v * v + k * x * x - h * k * x * v;
  };
  CHECK(form(m.position.ball, m.velocity.ball).overlaps(form(Ball(q.x0, 400), Ball(q.v0, 400))));
}

TEST_CASE("a free body is known exactly, however far") {
  NumericQuestion q = question("constant:a=-9.81", "1/50", "1e18");
  q.x0 = 0;
  const NumericMotion m = numeric_motion(find_integrator("symplectic-euler"), q);
  // Short by -a h t / 2.
  CHECK(m.position_shortfall.exact == Rational::parse("9.81") / 100 * q.steps / 50);
  CHECK(m.velocity_shortfall.exact == Rational(0));
}

TEST_CASE("a force of time is followed, with and without a spring") {
  for (const char* force :
       {"poly:3:f0=1,f1=-2,f2=1/3,f3=5", "poly:2:f0=2,f1=1/5,f2=-1+damped-spring:k=2,c=1/9"})
    for (const char* integrator : {"rk4", "symplectic-euler", "adams-bashforth-2"}) {
      const NumericQuestion q = question(force, "1/4", "25");
      const NumericMotion m = numeric_motion(find_integrator(integrator), q);
      const auto [x, v] = stepped_exactly(find_integrator(integrator), q, 25);
      CHECK(m.position.ball.contains(x));
      CHECK(m.velocity.ball.contains(v));
      CHECK(shown(m.position) == Rational::parse(x.significant(50)));
    }
}

TEST_CASE("what does not move is said exactly") {
  NumericQuestion q = question("constant:a=6+spring:k=3", "1/10", "1e30");
  q.x0 = 2;
  q.v0 = 0;
  for (const char* integrator : {"rk4", "implicit-midpoint", "velocity-verlet"}) {
    const NumericMotion m = numeric_motion(find_integrator(integrator), q);
    CHECK(m.position.exact == Rational(2));
    CHECK(m.velocity.exact == Rational(0));
    CHECK(m.position_shortfall.exact == Rational(0));
  }
}

TEST_CASE(
    "the flow's entries agree with MPFR at 100 digits, for random and for special stiffness and damping") {
  const Precision precision(130);
  std::mt19937 random(1687);
  const auto draw = [&](int low, int high) {
    return Rational(low + static_cast<int>(random() % (high - low + 1)), 1 + static_cast<int>(random() % 9));
  };
  std::vector<std::pair<Rational, Rational>> cases{
      {4, 4}, {1, 2}, {Rational(1, 9), Rational(2, 3)}, {3, 0}, {-3, 0}, {-3, 2}, {0, 3}, {0, -2}, {2, 3}};
  for (int i = 0; i < 60; ++i) cases.emplace_back(draw(-20, 40), draw(-5, 20));
  for (const auto& [stiffness, damping] : cases) {
    const Rational k = stiffness, c = damping;
    CAPTURE(k.str());
    CAPTURE(c.str());
    const Rational t = draw(1, 12);
    const BallFlow f = ball_flow(k, c, t, 500);
    // Taylor's series of exp(t A), at 300 digits: another route, no case distinction.
    std::vector<std::vector<Real>> total(2, std::vector<Real>(2));
    std::vector<std::vector<Real>> term(2, std::vector<Real>(2));
    const Real rk = real(k, 300), rc = real(c, 300), rt = real(t, 300);
    for (int i : {0, 1})
      for (int j : {0, 1}) total[i][j] = term[i][j] = real(Rational(i == j ? 1 : 0), 300);
    for (int n = 1; n < 1500; ++n) {
      std::vector<std::vector<Real>> next(2, std::vector<Real>(2));
      for (int j : {0, 1}) {
        next[0][j] = term[1][j] * rt / n;
        next[1][j] = (-rk * term[0][j] - rc * term[1][j]) * rt / n;
      }
      term = next;
      for (int i : {0, 1})
        for (int j : {0, 1}) total[i][j] = total[i][j] + term[i][j];
    }
    for (const auto& [ball, series] : {std::pair{&f.cosine, &total[0][0]},
                                       {&f.sine, &total[0][1]},
                                       {&f.cosine_rate, &total[1][0]},
                                       {&f.sine_rate, &total[1][1]}}) {
      if (ball->is_zero()) {
        CHECK(Real(abs(*series)) < real(Rational(10).pow(-200), 300));
        continue;
      }
      const auto digits = ball->significant(100);
      REQUIRE(digits);
      CHECK(near(Rational::parse(*digits), Rational::parse(series->str(110, std::ios_base::scientific)), 99));
    }
  }
}

TEST_CASE("the flow of numbers that are only known as balls is that of the exact numbers in them") {
  std::mt19937 random(1690);
  const auto draw = [&](int low, int high) {
    return Rational(low + static_cast<int>(random() % (high - low + 1)), 1 + static_cast<int>(random() % 9));
  };
  for (int i = 0; i < 200; ++i) {
    const Rational k = i % 5 == 0 ? Rational(0) : draw(-20, 40), c = i % 7 == 0 ? Rational(0) : draw(-5, 20);
    if (!k.is_zero() && k == c * c / 4) continue;
    const Rational t = draw(1, 12);
    CAPTURE(k.str());
    CAPTURE(c.str());
    const BallFlow exact = ball_flow(k, c, t, 300);
    const BallFlow inexact = ball_flow(Ball(k, 300), Ball(c, 300), Ball(t, 300));
    for (const auto& [one, other] : {std::pair{&exact.cosine, &inexact.cosine},
                                     {&exact.sine, &inexact.sine},
                                     {&exact.cosine_rate, &inexact.cosine_rate},
                                     {&exact.sine_rate, &inexact.sine_rate}}) {
      CHECK(one->overlaps(*other));
      CHECK((other->is_zero() || other->significant(60)));
    }
  }
  // Exactly critical: the balls cannot tell, and claim nothing.
  const BallFlow critical = ball_flow(Ball(Rational(1, 9), 100), Ball(Rational(2, 3), 100), Ball(1, 100));
  CHECK_FALSE(critical.sine.significant(1));
}

TEST_CASE(
    "an engine that damps by a power: the true damping is a logarithm, and the motion after n steps known") {
  NumericQuestion q = question("constant:a=-9+spring:k=4", "1/50", "200");
  q.parameters = {{"c", Rational(3, 10)}};
  q.x0 = 1;
  q.v0 = Rational(1, 2);
  const NumericMotion m = numeric_motion(find_integrator("cannon-es"), q);
  const double damping = -std::log(0.7), t = 4, w = std::sqrt(4 - damping * damping / 4);
  const double rest = -9.0 / 4, free = 1 - rest, decay = std::exp(-damping * t / 2);
  CHECK(std::stod(*m.exact_position.decimal) ==
        doctest::Approx(rest +
                        decay * (free * std::cos(w * t) + (0.5 + damping / 2 * free) / w * std::sin(w * t)))
            .epsilon(1e-13));
  double x = 1, v = 0.5;
  for (int n = 0; n < 200; ++n) {
    v = v * std::pow(0.7, 0.02) + 0.02 * (-9 - 4 * x);
    x += 0.02 * v;
  }
  CHECK(std::stod(*m.position.decimal) == doctest::Approx(x).epsilon(1e-11));
  CHECK(std::stod(*m.velocity.decimal) == doctest::Approx(v).epsilon(1e-11));
  CHECK(std::stod(*m.position_shortfall.decimal) ==
        doctest::Approx(std::stod(*m.exact_position.decimal) - x).epsilon(1e-9));
  CHECK_FALSE(m.exact_position.exact);
  CHECK(print(m.acceleration) == "-9 - 4*x + log(7/10)*v");
  // Fall with drag, from rest, after 10^18 steps: the terminal speed, -9/c.
  NumericQuestion fall = question("constant:a=-9", "1/50", "1e18");
  fall.parameters = q.parameters;
  CHECK(std::stod(*numeric_motion(find_integrator("cannon-es"), fall).exact_velocity.decimal) ==
        doctest::Approx(-9 / damping).epsilon(1e-13));
}

TEST_CASE("what is 0, or rational, is said to be so, also where the step has roots") {
  for (const char* name : {"forest-ruth", "yoshida4", "suzuki4", "mclachlan-s4"}) {
    CAPTURE(name);
    for (const char* steps : {"1", "7", "1000000"}) {
      const NumericMotion m =
          numeric_motion(find_integrator(name), question("poly:3:f0=1,f1=2,f2=-3,f3=1/2", "1/10", steps));
      REQUIRE(m.velocity_shortfall.exact);  // order 4: a quadrature that is exact for cubics
      CHECK(m.velocity_shortfall.exact->is_zero());
      REQUIRE(m.velocity.exact);
      CHECK(*m.velocity.exact == *m.exact_velocity.exact);
      CHECK(m.position_shortfall.decimal);
      CHECK_FALSE(m.position_shortfall.exact);
    }
  }
}

TEST_CASE("questions without an answer are refused with a sentence") {
  const Program p = find_integrator("implicit-midpoint");
  CHECK_THROWS_AS(numeric_motion(p, question("spring", "1/10", "5")), BadInput);
  CHECK_THROWS_AS(numeric_motion(p, question("spring:k=1", "1/10", "-5")), BadInput);
  CHECK_THROWS_AS(numeric_motion(p, question("spring:k=1", "1/10", "1/2")), BadInput);
  CHECK_THROWS_AS(numeric_motion(p, question("constant", "1/10", "5")), BadInput);
  // 1 + h^2 k/4 = 0: the stage of the implicit midpoint rule has no solution.
  CHECK_THROWS_WITH_AS(numeric_motion(p, question("spring:k=-400", "1/10", "5")),
                       doctest::Contains("singular"), Undefined);
  CHECK_THROWS_AS(force_named("constant:k=1"), BadInput);
  CHECK_THROWS_AS(force_named("poly:1:f2=1"), BadInput);
  CHECK_THROWS_AS(force_named("constant:a=1,a=2"), BadInput);
  CHECK_THROWS_AS(force_named("spring:a=1"), BadInput);
  for (const char* twice : {"spring+spring", "spring:k=1+damped-spring", "drag+damped-spring", "drag+drag"})
    CHECK_THROWS_WITH_AS(force_named(twice), doctest::Contains("two parts of it"), BadInput);
  CHECK(force_named("constant+drag+spring").linear());
}
