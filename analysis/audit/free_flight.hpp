// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/program/tape.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

/// How far a step drifts and kicks in all, in units of h: both have to be 1.
struct StepSums {
  KnownDigits drift;  ///< h v in the new position of a free body
  KnownDigits kick;   ///< h a in the new velocity, the force the same everywhere
};

/// none  when the step solves for a stage, or has coefficients that are no polynomials in h
std::optional<StepSums> step_sums(const Program& program, const Values& given = {});

}  // namespace shortfall
