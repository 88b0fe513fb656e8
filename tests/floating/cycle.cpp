// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/cycle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

namespace {

FloatQuestion spring(const std::string& integrator, const Rational& h,
                     const std::string& force = "spring:k=1") {
  FloatQuestion q;
  q.program = find_integrator(integrator);
  q.parameters = parameter_values(q.program);
  q.force = force_named(force);
  q.h = h;
  q.x0 = 1;
  return q;
}

/// With a table of all states, which needs memory.
std::pair<std::int64_t, std::int64_t> by_table(const FloatFormat& format, const FloatQuestion& q) {
  const auto run = float_run(format, q);
  std::map<std::vector<double>, std::int64_t> seen;
  std::vector<double> state;
  for (std::int64_t n = 0;; ++n) {
    run->carried(state);
    for (double& d : state)
      if (d == 0) d = std::signbit(d) ? -1e-320 : 1e-320;  // 0 and -0 are two states
    const auto [at, fresh] = seen.emplace(state, n);
    if (!fresh) return {at->second, n - at->second};
    run->step();
  }
}

}  // namespace

TEST_CASE("tails and periods are those that a table of all states finds") {
  for (const char* name : {"bf16", "f16", "bf16+tozero"})
    for (const char* integrator : {"symplectic-euler", "velocity-verlet", "leapfrog", "rk4"})
      for (const Rational& h : {Rational(1, 8), Rational(1, 3)}) {
        CAPTURE(name);
        CAPTURE(integrator);
        const FloatQuestion q = spring(integrator, h);
        const CycleSearch s = cycle(float_format(name), q, 1'000'000);
        REQUIRE(s.found.has_value());
        const auto [tail, period] = by_table(float_format(name), q);
        CHECK(s.found->tail == tail);
        CHECK(s.found->period == period);
      }
}

TEST_CASE("what is said of all time holds far beyond the first periods") {
  const FloatQuestion q = spring("symplectic-euler", Rational(1, 8));
  const CycleSearch s = cycle(float_format("f16"), q, 1'000'000);
  REQUIRE(s.found.has_value());
  const auto run = float_run(float_format("f16"), q);
  int turns = 0;
  double last = 0;
  const std::int64_t from = s.found->tail, to = from + 5 * s.found->period;
  for (std::int64_t n = 0; n <= to; ++n) {
    const auto [x, v] = run->rough();
    CHECK(std::abs(x) <= s.found->largest_x);
    const double energy = v * v / 2 + x * x / 2;
    CHECK(energy >= s.found->least_energy);
    CHECK(energy <= s.found->largest_energy);
    if (n > from && last < 0 && x >= 0) ++turns;
    last = x;
    run->step();
  }
  CHECK(turns == 5 * s.found->turns);
}

TEST_CASE("runs without a cycle say why, and a limit is kept") {
  CHECK(cycle(float_format("f16"), spring("explicit-euler", 1), 10'000).not_finite_at.has_value());
  const CycleSearch none = cycle(float_format("f64"), spring("symplectic-euler", Rational(1, 8)), 1000);
  CHECK(!none.found);
  CHECK(none.looked_at == 1000);
  CHECK_THROWS_AS(cycle(float_format("f32"), spring("rk4", 1, "poly:1:f0=1,f1=1"), 100), Unable);
  CHECK_THROWS_AS(cycle(float_format("f128"), spring("rk4", 1), 100), Unable);
  CHECK_THROWS_AS(cycle(float_format("f32+kahan"), spring("rk4", 1), 100), Unable);
}
