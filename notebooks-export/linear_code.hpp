// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/correction/linear_kit.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The kit of a linear force as a class, in binary64 in every language: made from k, c, the integrator's
/// letters and dt, it has what the integrator is given (`given_k`, `given_c`, and a function for the force),
/// the launch and the read-out.
///
/// Where the parameters are roots of equations the class solves these by Newton's method, followed from small
/// steps up to dt; where it finds none, or where the kit is known not to reach, they are NaN.
///
/// throws  Undefined  when there is no kit, with the obstruction;  Unable  when a formula cannot be written
std::string linear_kit_code(const LinearKit& kit, const LinearDerivation& derivation, Language language);

}  // namespace shortfall
