// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/motion/derivation.hpp"

namespace shortfall {

/// The derivation, told as one does on paper: write a step out, unroll it, pull the constants out of the sum,
/// add up with Gauss and Faulhaber, gather n h into t, subtract from the true motion. Each line is proved by
/// exact evaluation.
std::vector<DerivationStep> derivation_steps(const Derivation& derivation, bool has_finish,
                                             const Progress& progress = {});

}  // namespace shortfall
