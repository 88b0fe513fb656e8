// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace shortfall::native {

// What lies between the library and code that is compiled for other registers: plain functions and numbers. A
// function of a header (of std::vector, say) that was compiled there could be taken by the linker for
// everybody, and would not run on an older processor.

template <class S>
struct LaneParameter {
  const char* name;
  S value;
  int whole;
};

/// A force of so many trajectories.
template <class S>
struct LaneForce {
  void* object;
  void (*call)(void* object, const S* x, const S* v, S t, S* a, std::size_t count);
};

template <class S>
struct LaneSetup {
  S h;
  LaneForce<S> force;
  const LaneParameter<S>* parameters;
  std::size_t parameter_count;
  S (*number)(const char* text);  ///< the S nearest to an exact number
};

/// An integrator, compiled for K trajectories at once.
template <class S>
struct LaneCode {
  const char* integrator;
  std::size_t lanes;
  void* (*made)(const LaneSetup<S>& setup);
  /// Runs from x0, v0, t0, K of each, and leaves what is reported in x and v.
  void (*run)(void* object, S* x, S* v, S t0, std::int64_t steps);
  void (*deleted)(void* object);
};

template <class S>
struct LaneTable {
  const LaneCode<S>* codes;
  std::size_t count;
};

/// Compiled for AVX2; to be called where the processor has it. Empty where the compiler has not.
LaneTable<float> avx2_lanes_float();
LaneTable<double> avx2_lanes_double();

}  // namespace shortfall::native
