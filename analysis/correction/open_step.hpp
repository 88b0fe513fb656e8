// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "analysis/correction/matching.hpp"
#include "analysis/motion/closed_form.hpp"
#include "analysis/motion/force.hpp"
#include "analysis/motion/spectrum.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// One step with the stiffness and the damping that the integrator is given left open, as letters: what
/// corrections are solved for.
struct OpenStep {
  StepMap map;
  ClosedForm form;
  Matrix matrix;                  ///< of the carried vectors
  int zeros = 0;                  ///< multiplicity of the eigenvalue 0
  std::vector<Fraction> nonzero;  ///< the characteristic polynomial over z^zeros: monic, lowest power first
  std::vector<Fraction> pair;  ///< its factor {D, -T, 1} that tends to (z - 1)^2; empty when it is no factor
                               ///< over the rational functions

  int states() const { return map.force.states; }
  /// A motion under the force t^d alone that is polynomial in n: what is reported of it, and its carried
  /// vectors. Without a spring it is one of many, which differ by a shift.
  Fraction position(int d) const { return form.position[2 + d].polynomial(); }
  Fraction velocity(int d) const { return form.velocity[2 + d].polynomial(); }
  Fraction state(int s, int d) const { return form.states[s][2 + d].polynomial(); }
  /// The letters that stand for exp and pow, and what these are for h = 0: 1, where the exponent is a
  /// multiple of h.
  BranchPoint small_step_values() const;
  /// Column x0 (0), v0 (1) or the force t^d (2 + d) of what `start` makes of the beginning.
  Fraction start(int s, int column) const;
};

/// A letter of the step and what is put in its place.
using Replacement = std::pair<Letter, Fraction>;

/// param   force  whose k and c are letters where they are to be solved for
/// param   own    parameters of the integrator that take the place of k or c
/// throws  Undefined, Unable  as step_map and closed_form
OpenStep open_step(const Program& program, const Force& force, const Values& given, int substeps,
                   const std::vector<Replacement>& own = {});

}  // namespace shortfall
