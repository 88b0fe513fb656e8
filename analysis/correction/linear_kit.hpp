// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/motion/linear_derivation.hpp"

namespace shortfall {

/// One replacement of the kit: what the integrator is given instead.
struct LinearCorrection {
  enum class Kind { parameter, launch, read_out };
  Kind kind;
  std::string target;  ///< "k", "c", "a", "v0", "v"
  Expr value;          ///< what replaces it, in C, S, D, h, k, c, a, x0, v0 (or x_n, v_n for a read-out)
  std::string reason;
};

/// A quadratic form of the reported state that one step multiplies by the determinant: xx x^2 + xv x v + v^2.
struct QuadraticForm {
  Fraction xx;
  Fraction xv;
  Fraction factor;  ///< per step; 1: conserved exactly
};

/// How to make an integrator exact on every frame under -k x, -k x - c v, a - c v, also with a constant
/// force.
struct LinearKit {
  bool exists = false;
  bool impossible =
      true;  ///< when it does not exist: proved; false: we found none, with the limit in `obstruction`
  std::string obstruction;
  std::string proof;
  std::vector<LinearCorrection> corrections;
  std::vector<Definition> definitions;  ///< C, S, D
  std::optional<QuadraticForm> conserved;
};

/// Matches trace and determinant by the parameters k~ and c~, then the first position by the launch;
/// everything is solved for, exactly.
///
/// Two motions that satisfy the same linear recurrence of order two and agree at n = 0 and 1 agree for every
/// n: that is the proof, and its premises are compared as rational functions of h, k, c and of C, S, D, the
/// entries of the exact flow over one step. throws  BadInput, Undefined, Unable  as linear_derivation
LinearKit linear_kit(const Program& program, const Force& force, const Values& given = {}, int substeps = 1);

/// The quadratic form that belongs to a 2 x 2 amplification matrix; empty when v does not move x.
std::optional<QuadraticForm> quadratic_form(const std::vector<std::vector<Fraction>>& amplification);

}  // namespace shortfall
