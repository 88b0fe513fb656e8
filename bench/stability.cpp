// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability.hpp"

#include <benchmark/benchmark.h>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

namespace {

/// Where the damping of an engine depends on the frame, for frames of 1/60 s.
Stability report(const Program& p, int substeps = 1) {
  try {
    return stability(p, {}, substeps);
  } catch (const Unable&) {
    return stability(p, {}, substeps, Rational(1, 60));
  }
}

/// Everything that `shortfall stability` says about an integrator, for all of the catalogue: less than 5 s.
void whole_catalogue(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    for (const Program& p : catalogue()) benchmark::DoNotOptimize(report(p));
}

/// With frames of four substeps: formulas of a frame are longer.
void four_substeps(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state)
    for (const Program& p : catalogue()) benchmark::DoNotOptimize(report(p, 4));
}

/// One integrator: 0 velocity Verlet, 1 the classical method, 2 SDIRK4.
void one_integrator(benchmark::State& state) {
  const char* const names[] = {"velocity-verlet", "rk4", "sdirk4"};
  const Program p = find_integrator(names[state.range(0)]);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stability(p));
}

BENCHMARK(whole_catalogue)->Unit(benchmark::kMillisecond);
BENCHMARK(four_substeps)->Unit(benchmark::kMillisecond);
BENCHMARK(one_integrator)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
