// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "analysis/motion/derivation.hpp"
#include "analysis/motion/faulhaber.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

namespace {

/// All sums of powers of degree 0 to 50; nothing is kept between rounds.
void faulhaber_to_50(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(power_sums(50));
}

/// The n-step map of symplectic Euler under a force polynomial in time: lowering, one step in letters, closed
/// form.
void n_step_map(benchmark::State& state) {
  const Program p = find_integrator("symplectic-euler");
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(closed_form(step_map(lower(p), static_cast<int>(state.range(0)))));
}

/// Derivation with its proof for every integrator of the catalogue under poly:0 to poly:6; argument 1: with
/// the lines told and proved.
void whole_catalogue(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    for (const Program& p : catalogue())
      for (int degree = 0; degree <= 6; ++degree)
        benchmark::DoNotOptimize(derivation(p, degree, {}, 1, state.range(0) == 1));
}

BENCHMARK(faulhaber_to_50)->Unit(benchmark::kMillisecond);
BENCHMARK(n_step_map)->Arg(6)->Arg(20)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_catalogue)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
