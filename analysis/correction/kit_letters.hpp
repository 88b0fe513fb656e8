// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/problems/letters.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// The letters of corrections under linear forces: those of the step, where k and c stand for what the
/// integrator is given; then the true k and c, and the exact flow over one step.
inline constexpr Letter kFlowTrace =
    kTimeLetter;  ///< T, the trace of the exact flow; no correction has the letter of time
inline constexpr Letter kTrueStiffness = 11;
inline constexpr Letter kTrueDamping = 12;
inline constexpr Letter kFlowCosine = 13;  ///< C, position after h from x0 = 1, v0 = 0
inline constexpr Letter kFlowSine = 14;    ///< S, position after h from x0 = 0, v0 = 1
inline constexpr Letter kFlowDecay = 15;   ///< D = e^(-c h), the determinant of the exact flow

/// What kits call the j-th derivative of the force by time: a, f, f', f'', ...
Expr derivative_name(int j, int degree);
/// The j-th derivative of f0 + f1 t + ..., at t or at 0.
Expr derivative(int j, int degree, bool at_zero);

}  // namespace shortfall
