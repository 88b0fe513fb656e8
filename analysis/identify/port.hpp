// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/identify/fit.hpp"

namespace shortfall {

/// A jump that was tuned in one engine, and where it is to go.
struct PortQuestion {
  Candidate from, to;
  Rational from_dt, to_dt;
  double launch = 0;  ///< upwards
  double g = 9.81;
  double c = 0;  ///< damping number of the first engine
  double k = 0;  ///< of a spring to the origin, over the mass
};

/// The numbers that give the same motion in the other engine.
struct Port {
  Fit fit;                 ///< of the second engine: launch, damping, spring, acceleration
  double held = 0;         ///< acceleration to hold besides gravity
  std::size_t frames = 0;  ///< common frames that were compared
  double duration = 0;     ///< seconds
  double peak = 0;         ///< highest common frame of the first engine
  double error = 0;        ///< the largest difference of the positions, at common frames
  bool exact = false;      ///< it is rounding
};

/// Launch, damping, spring and a held acceleration, with which the second map is at the same place at every
/// frame that both have; where it cannot be, the least sum of squares over these frames.
///
/// throws  Unable  when the two have no frames in common, or the second explodes
Port port(const PortQuestion& question);

}  // namespace shortfall
