// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/exact_dyadic.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/gmp.hpp"
#include "analysis/floating/exact_trajectory.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/motion/random_integrator.hpp"

using namespace shortfall;

namespace {

/// A step over 2^places with these entries of M.
ExactStep random_step(shortfall::testing::Chance& chance, int size, int places) {
  ExactStep step;
  step.base = mpz_class(1) << places;
  for (int i = 0; i < size; ++i) {
    step.matrix.emplace_back();
    for (int j = 0; j < size; ++j) {
      mpz_class m = i == j && chance.number(0, 2) > 0 ? step.base : mpz_class(chance.number(-9, 9));
      if (chance.number(0, 3) == 0) m <<= chance.number(0, places);
      if (chance.number(0, 9) == 0) m = step.base * chance.number(-3, 3) + m;
      step.matrix.back().push_back(m);
    }
    step.start.emplace_back(chance.number(-1000, 1000));
  }
  return step;
}

}  // namespace

TEST_CASE("growing fixed point makes the same whole numbers as the matrix, whatever its entries") {
  shortfall::testing::Chance chance(77);
  int used = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int size = chance.number(1, 5), places = chance.number(1, 150);
    const ExactStep step = random_step(chance, size, places);
    std::optional<ExactDyadic> fixed = ExactDyadic::of(step);
    if (!fixed) continue;
    ++used;
    const int first = chance.number(0, 5);
    std::vector<mpz_class> z = step.start;
    for (int n = 0; n < first; ++n) z = product(step.matrix, z);
    fixed->load(z, first);
    for (int n = first; n < first + 60; ++n) {
      CAPTURE(trial);
      CAPTURE(n);
      REQUIRE(fixed->values() == z);
      const mpz_class scale = mpz_class(1) << (places * n);
      for (int i = 0; i < size; ++i) {
        REQUIRE(fixed->sign(i) == sgn(z[i]));
        const Ball ball = fixed->scaled(i, 90);
        REQUIRE(ball.contains(rational(z[i], scale)));
        if (z[i] != 0) REQUIRE(ball.significant(24));
      }
      z = product(step.matrix, z);
      fixed->step();
    }
  }
  CHECK(used > 200);
}

TEST_CASE("growing fixed point is for powers of two only") {
  ExactStep step;
  step.matrix = {{50, 1}, {0, 50}};
  step.start = {1, 1};
  step.base = 50;
  CHECK(!ExactDyadic::of(step));
  step.base = 1;
  CHECK(!ExactDyadic::of(step));
  step.base = 64;
  CHECK(ExactDyadic::of(step));
}

TEST_CASE("a dyadic trajectory is the same however one looks at it") {
  shortfall::testing::Chance chance(78);
  int compared = 0;
  for (const char* name : {"symplectic-euler", "velocity-verlet", "rk4", "explicit-euler", "ruth3"}) {
    NumericQuestion q;
    q.force = force_named(chance.number(0, 1) ? "spring:k=3" : "constant:a=-9+damped-spring:k=2,c=1/4");
    q.h = Rational(chance.number(1, 5), 64);
    q.x0 = Rational(chance.number(1, 9), 7);
    q.v0 = Rational(chance.number(-9, 9), 3);
    CAPTURE(name);
    const Program program = find_integrator(name);
    ExactTrajectory one(program, q), many(program, q);
    // Every frame of the first; the second in strides, long and short, with and without a look between.
    while (one.frame() < 400) {
      const int stride = chance.number(0, 3) ? 1 : chance.number(1, 40);
      many.advance(stride);
      for (int n = 0; n < stride; ++n) {
        one.advance();
        (void)one.velocity().sign();
      }
      if (chance.number(0, 2) == 0) {
        REQUIRE(many.position().rational() == one.position().rational());
        REQUIRE(many.velocity().significant(30) == one.velocity().rational().significant(30));
        ++compared;
      }
    }
    ExactTrajectory jumped(program, q);
    jumped.jump(one.frame());
    CHECK(jumped.position().rational() == one.position().rational());
    CHECK(jumped.velocity().rational() == one.velocity().rational());
    CHECK(one.position().minus(one.position().rational(), 64).is_zero());
  }
  CHECK(compared > 60);
}
