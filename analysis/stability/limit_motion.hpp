// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/expression.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// The oscillator x'' = -w^2 x stepped with exactly the h for which h^2 w^2 = y: position and velocity after
/// n steps as formulas.
///
/// Formulas are in x0, v0, h, n; powers of one base stand in front: (-1)^n*(x0 - n*h*v0).
struct LimitMotion {
  Expr position;
  Expr velocity;
  int valid_from = 0;  ///< the smallest n for which they hold
  bool proved = false;
  /// What multiplies the highest power of n: combinations of x0 and v0 with integer coefficients (times
  /// powers of h); 0 when it stays bounded.
  Expr position_growth;
  Expr velocity_growth;
};

/// None when the eigenvalues are not rational there.
///
/// param   substeps  the program's steps in a frame; h is the frame
std::optional<LimitMotion> limit_motion(const Program& program, const Values& parameters, int substeps,
                                        const Rational& y);

}  // namespace shortfall
