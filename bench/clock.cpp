// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/clock.hpp"

#include <benchmark/benchmark.h>

using namespace shortfall;

namespace {

const char* const kFormats[] = {"f16", "bf16", "f32", "f64", "x87", "f128", "mpfr:50"};

ClockQuestion question(const benchmark::State& state) {
  ClockQuestion q;
  static_cast<ClockArithmetic&>(q) = clock_arithmetic(kFormats[state.range(0)]);
  q.dt = Rational(1, 60);
  q.additions = Rational(10).pow(18);
  return q;
}

/// The value after 10^18 additions: less than 1 ms.
void value(benchmark::State& state) {
  const ClockQuestion q = question(state);
  const Accumulator clock{q.format, q.rounding, 0, *rounded(q.dt, q.format, q.rounding)};
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(accumulated(clock, q.additions));
  state.SetLabel(q.format_name);
}

/// Everything that `shortfall clock` says about it: less than 1 ms in binary32.
void whole_report(benchmark::State& state) {
  ClockQuestion q = question(state);
  q.most_stepped = 0;
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(clock_report(q));
  state.SetLabel(q.format_name);
}

BENCHMARK(value)->DenseRange(0, 6)->Unit(benchmark::kMicrosecond);
BENCHMARK(whole_report)->DenseRange(0, 6)->Unit(benchmark::kMicrosecond);

}  // namespace
