// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/stability/amplification.hpp"
#include "analysis/stability/windows.hpp"

namespace shortfall {

/// What a step does to a velocity that only drag acts on, x'' = -c v, in terms of d = c h.
struct Drag {
  std::optional<Fraction> factor;  ///< each step multiplies the velocity by it, d in the letter of c; none with further eigenvalues
  Windows windows;                 ///< where the motion stays bounded
  /// The smallest d from which on each step turns the velocity round: the factor changes its sign. None when it never does, or there is none.
  std::optional<RealRoot> overshoots;
};

/// param   damped  an amplification matrix with damping, its parameters numbers
Drag drag(const Amplification& damped);

}  // namespace shortfall
