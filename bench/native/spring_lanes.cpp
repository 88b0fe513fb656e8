// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for AVX2: see bench/CMakeLists.txt.
#include "bench/native/spring_lanes.hpp"

#include "analysis/native/lanes.hpp"
#include "native/symplectic-euler.hpp"

namespace shortfall::bench {

void spring_lanes(std::span<double> x, std::span<double> v, double k, double h, std::int64_t steps) {
  using V = native::Lanes<double, 16, native::Avx2>;
  using Stepper = native::SymplecticEuler<double, V, Spring>;
  const auto no_numbers = [](const char*) { return 0.0; };  // the step of symplectic Euler has none
  Stepper stepper(h, V(0.0), Spring{k}, no_numbers, Stepper::Parameters(no_numbers));
  for (std::size_t first = 0; first + V::kLanes <= x.size(); first += V::kLanes) {
    V position, velocity;
    for (std::size_t lane = 0; lane < V::kLanes; ++lane) {
      position[lane] = x[first + lane];
      velocity[lane] = v[first + lane];
    }
    stepper.begin(position, velocity, 0);
    stepper.run(steps);
    const auto reported = stepper.read_out();
    for (std::size_t lane = 0; lane < V::kLanes; ++lane) {
      x[first + lane] = reported.first[lane];
      v[first + lane] = reported.second[lane];
    }
  }
}

}  // namespace shortfall::bench
