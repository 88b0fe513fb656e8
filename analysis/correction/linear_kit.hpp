// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/implicit_parameters.hpp"
#include "analysis/motion/linear_derivation.hpp"

namespace shortfall {

/// One replacement of the kit: what the integrator is given instead.
struct LinearCorrection {
  enum class Kind { parameter, launch, read_out };
  Kind kind;
  std::string target;  ///< "k", "c", "a" or "f", "x0", "v0" or a carried vector, "v"
  Expr value;  ///< what replaces it, in C, S, T, D, h, k, c, a, x0, v0 (or x_n, v_n for a read-out), the
               ///< parameters k_new, c_new where these are roots of equations, and f, f', f'' for a force
               ///< polynomial in time, at t = 0 in a launch, at t = n h in a read-out
  std::string reason;
  Expr spelled;  ///< the same in f0, f1, ..., t
};

/// A quadratic form of the reported state that one step multiplies by the determinant: xx x^2 + xv x v + v^2.
struct QuadraticForm {
  Fraction xx;
  Fraction xv;
  Fraction factor;  ///< per step; 1: conserved exactly
};

/// How to make an integrator exact on every frame under -k x, -k x - c v, a - c v, also with a force that is
/// polynomial in time.
struct LinearKit {
  bool exists = false;
  bool impossible =
      true;  ///< when it does not exist: proved; false: we found none, with the limit in `obstruction`
  std::string obstruction;
  std::string proof;
  std::vector<std::string>
      notes;  ///< what does not exist, and why: a stiffness without a damping, for example
  std::vector<LinearCorrection> corrections;
  std::vector<FlowCase> other_flows;    ///< C and S, as functions of t = h, where k and c are of another kind
  std::vector<Definition> definitions;  ///< C, S, T, D; k_new, c_new where square roots give them
  std::vector<Definition> step_definitions;  ///< m11, ...: entries of the step with k_new, c_new
  std::optional<ImplicitParameters>
      implicit;                             ///< how k_new, c_new are found where they are roots of equations
  std::vector<ExtraLetters::Extra> extras;  ///< roots, exp and pow of the integrator, which are letters too
  std::vector<std::string> letters;         ///< names of the letters in its equations
  std::optional<QuadraticForm> conserved;

  Wording wording() const { return {letters, "n", true}; }
};

/// Matches the spectrum of the step to that of the exact flow by the parameters k~ and c~, the motion under a
/// force that is polynomial in time by the force, then the first two positions by the launch; everything is
/// solved for, exactly.
///
/// Two motions that satisfy the same linear recurrence of order two and agree at n = 0 and 1 agree for every
/// n: that is the proof, and its premises are compared as rational functions of h, k, c and of C, S, T, D,
/// the entries, trace and determinant of the exact flow over one step. throws  BadInput, Undefined, Unable as
/// linear_derivation
LinearKit linear_kit(const Program& program, const Force& force, const Values& given = {}, int substeps = 1);

/// The quadratic form that belongs to a 2 x 2 amplification matrix; empty when v does not move x.
std::optional<QuadraticForm> quadratic_form(const std::vector<std::vector<Fraction>>& amplification);

}  // namespace shortfall
