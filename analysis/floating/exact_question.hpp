// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/motion/step_matrix.hpp"

namespace shortfall {

/// The step of a question that has an exact trajectory: all its entries are rational numbers.
///
/// throws  BadInput   for a letter of the force without a number
///         Unable  when a coefficient is irrational, or the step is not linear
///         Undefined  when a stage is singular
StepMatrix exact_matrix(const Program& program, const NumericQuestion& question);

}  // namespace shortfall
