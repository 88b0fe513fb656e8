// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/force.hpp"
#include "analysis/problems/extra_letters.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// The equation that an integrator with a spring or a damper of its own is meant for: x'' = a - k x - c v.
///
/// units  stiffness 1/T^2, damping 1/T; rational functions of the parameters, where a logarithm is a letter:
/// log(1 - c) for an integrator that leaves (1 - c)^t of the velocity
struct OwnEquation {
  Fraction stiffness;
  Fraction damping;
  std::vector<std::string> parameters;  ///< names of those that occur in it
};

/// A program's `solves` as a linear form in a, x and v; zero where it has none.
///
/// param   extras  of the step map with which the coefficients are to be compared: its functions
/// throws  Unable  when it is not linear in a(x, v, t), x, v, or gives the force another weight than 1
OwnEquation own_equation(const Program& program, const Values& given, ExtraLetters& extras);

/// The force of the motion that an integrator is meant to follow when a user asks for a force: the sum of it
/// and the integrator's own equation. `drag` and `damped-spring` then mean the integrator's own damping.
///
/// throws  BadInput  when the force brings a number for a damping (a stiffness) that the integrator has
/// itself
Force with_own_equation(const Force& asked, const Program& program, const Values& given,
                        ExtraLetters& extras);
Force with_own_equation(const Force& asked, const Program& program, const Values& given);

/// What the integrator is given of such a force: all but its own.
Force without_own_equation(Force force);

/// The letter, and the power of it, that is e^(-c h) for the damping c: exp and pow in a step whose exponent
/// is that of the true decay, over one of so many equal parts of it.
struct ExactDecay {
  Letter letter;
  int power;
};
std::optional<ExactDecay> exact_decay(const Fraction& damping,
                                      const std::vector<ExtraLetters::Extra>& extras);

}  // namespace shortfall
