// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An engine's frame as its source has it, and the frame time and the gravity with which jumps are tested.

#include "analysis/algebra/rational.hpp"

namespace shortfall::testing {

inline const Rational kDt(1, 50), kG(981, 100);

/// Rapier's frame: N kicks and drifts, then the damping. PhysX' frame is its damping, then the same.
struct EngineLoop {
  Rational c;
  int substeps;
  bool damps_first;
  Rational x = 0, v = 0;

  void frame(const Rational& acceleration) {
    if (damps_first) v *= Rational(1) - c * kDt;
    for (int s = 0; s < substeps; ++s) {
      v += acceleration * kDt / substeps;
      x += v * kDt / substeps;
    }
    if (!damps_first) v /= Rational(1) + c * kDt;
  }
};

}  // namespace shortfall::testing
