// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/stability/amplification.hpp"
#include "analysis/stability/windows.hpp"

namespace shortfall {

/// What a step does to a velocity that only drag acts on, x'' = -c v, in terms of d = c h.
struct Drag {
  std::optional<Fraction> factor;  ///< each step multiplies the velocity by it, d in the letter of c; none
                                   ///< with further eigenvalues
  Windows windows;                 ///< where the motion stays bounded
  /// Where each step turns the velocity round: the factor is negative.
  struct Reversal {
    RealRoot from;
    std::optional<RealRoot> to;  ///< none: without end
  };
  std::vector<Reversal> reversals;  ///< in increasing order; empty when it never is, or there is no factor
};

/// param   damped  an amplification matrix with damping, its parameters numbers
Drag drag(const Amplification& damped);

}  // namespace shortfall
