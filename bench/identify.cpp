// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <cstdio>
#include <string>

#include "analysis/identify/identification.hpp"
#include "analysis/program/catalogue.hpp"

using namespace shortfall;

namespace {

/// 300 frames of a fall in three axes, as a program writes them.
std::string log_text(const char* engine, double damping) {
  const Program program = find_integrator(engine);
  const Candidate c = candidate(program, std::nullopt);
  EngineFlight flight;
  flight.v0 = {1, 20, 0.5};
  flight.gravity = {0, -9.81, 0};
  flight.c = damping;
  flight.arithmetic = Arithmetic::binary32;
  std::vector<std::size_t> frames(300);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = i;
  std::string text = "time,x,y,z,vx,vy,vz\n";
  fly(c, frames, 1.0 / 60, flight, [&](std::size_t row, const Log::Triple& x, const Log::Triple& v) {
    char line[200];
    std::snprintf(line, sizeof line, "%.12g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", static_cast<double>(row) / 60,
                  x[0], x[1], x[2], v[0], v[1], v[2]);
    text += line;
    return true;
  });
  return text;
}

/// One log against every map that is known: less than 2 s.
void one_log(benchmark::State& state) {
  const std::string text = log_text(state.range(0) == 0 ? "physx" : "rapier", state.range(0) == 0 ? 0 : 0.5);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(identify(parse_log(text, "log")));
  state.SetLabel(state.range(0) == 0 ? "undamped" : "damped");
}

BENCHMARK(one_log)->DenseRange(0, 1)->Unit(benchmark::kMillisecond);

}  // namespace
