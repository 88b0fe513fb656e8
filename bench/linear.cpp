// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

namespace {

NumericQuestion question(const char* force, int steps_exponent) {
  NumericQuestion q;
  q.force = force_named(force);
  q.h = Rational(1, 10);
  q.x0 = 1;
  q.steps = Rational(10).pow(steps_exponent);
  return q;
}

/// 50 certain digits of x_n, v_n, the true motion and the shortfall for n = 10^argument, an oscillation.
void far_spring(benchmark::State& state) {
  const Program p = find_integrator("velocity-verlet");
  const NumericQuestion q = question("spring:k=1", static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(numeric_motion(p, q));
}

/// The same with damping and a force that is a polynomial in time.
void far_damped_poly(benchmark::State& state) {
  const Program p = find_integrator("rk4");
  const NumericQuestion q =
      question("poly:2:f0=1,f1=-2,f2=1/3+damped-spring:k=4,c=1/1000", static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(numeric_motion(p, q));
}

/// Every integrator of the catalogue, n = 10^18, a spring.
void far_catalogue(benchmark::State& state) {
  const NumericQuestion q = question("spring:k=1", 18);
  for ([[maybe_unused]] auto _ : state)
    for (const Program& p : catalogue()) try {
        benchmark::DoNotOptimize(numeric_motion(p, q));
      } catch (const Unable&) {  // not a linear step
      }
}

/// Closed form, proof and exact corrections of one integrator under a damped spring.
void derive_and_correct(benchmark::State& state, const char* integrator, const char* force) {
  const Program p = find_integrator(integrator);
  const Force f = force_named(force);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(linear_derivation(p, f));
    benchmark::DoNotOptimize(linear_kit(p, f));
  }
}

BENCHMARK(far_spring)->Arg(3)->Arg(9)->Arg(18)->Arg(100)->Unit(benchmark::kMicrosecond);
BENCHMARK(far_damped_poly)->Arg(9)->Arg(18)->Unit(benchmark::kMicrosecond);
BENCHMARK(far_catalogue)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_and_correct, symplectic_euler, "symplectic-euler", "damped-spring")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_and_correct, rk4, "rk4", "constant+damped-spring")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_and_correct, generalised_alpha, "generalised-alpha", "constant+damped-spring")
    ->Unit(benchmark::kMillisecond);

}  // namespace
