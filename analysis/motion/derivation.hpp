// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/closed_form.hpp"
#include "analysis/motion/formula_text.hpp"
#include "analysis/motion/random_check.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// One line of a derivation: left = right, why, and how it was proved.
struct DerivationStep {
  Expr left;
  Expr right;
  std::string why;
  int points = 0;  ///< at how many consecutive n both sides were compared exactly, all other letters symbolic
  bool proved = false;
};

/// What is known exactly about an integrator under a force polynomial in time.
///
/// Formulas are in x0, v0, the force's letters (a, or f0, f1, ...), h, t = n h, n, parameters.
struct Derivation {
  std::string integrator;
  int degree = 0;
  int substeps = 1;
  StepMap map;
  ClosedForm form;
  Motion shortfall_position_motion;  ///< exact minus computed, as closed forms
  Motion shortfall_velocity_motion;
  Expr position;  ///< after n steps, as reported
  Expr velocity;
  Expr exact_position;
  Expr exact_velocity;
  Expr shortfall_position;
  Expr shortfall_velocity;
  std::vector<DerivationStep> steps;
  MotionProof proof;
  RandomCheck check;
  std::vector<std::string> assumptions;
  int digits = 0;  ///< of the coefficients that are known to some digits only (approx); 0 when all are exact

  bool proved() const;
  Wording wording() const { return {map.letters, "n", true}; }
};

/// Derives and proves.
///
/// param   degree  of the force polynomial, 0 for a constant one
/// param   tell    whether the steps of the derivation are wanted, or only the result
/// param   progress  is told how far it is
/// throws  Unable  with the reason when there is no closed form of this kind; BadInput for a degree above
/// 1000
Derivation derivation(const Program& program, int degree, const Values& given = {}, int substeps = 1,
                      bool tell = true, const Progress& progress = {});

}  // namespace shortfall
