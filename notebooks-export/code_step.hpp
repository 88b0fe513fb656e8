// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// What a step does for its force.
enum class ForceInCode {
  constant,  ///< it is a number, a
  called,    ///< acceleration(x, v, t) is called, which the user writes
};

/// One frame of an integrator under a constant acceleration, in another language: lines without indentation
/// of their own. They use the names x, v, a, and dt.
struct CodeStep {
  std::vector<std::string> start;  ///< once, where x, v and a are known: declares the other carried vectors
  std::vector<std::string> step;   ///< once a frame
  bool velocity_changes = true;    ///< whether v is ever assigned
  std::string position;            ///< what holds the position that is reported after it
  std::vector<std::string> parameters;  ///< names of the parameters that occur
  std::vector<std::string> finish;      ///< of a step for a class: what is reported, when that is not x and v
  std::string velocity;                 ///< of a step for a class: what holds the velocity that is reported
};

/// Under a constant acceleration (ForceInCode::constant) the places where the force is evaluated do not
/// matter; what only serves to find them is left out, and implicit stages become explicit.
///
/// param   in_binary64  constants keep the digits of binary64 in every language
/// throws  Unable  when a stage stays implicit, or the step reads the clock under a constant force
CodeStep code_step(const Program& program, const Values& parameters, Language language,
                   ForceInCode force = ForceInCode::constant, bool in_binary64 = false);

/// The step for a class that calls the force and carries x, v, t, dt and the states: `start` gives the states
/// their values, `finish` stands apart, and both x and v are reported.
///
/// param   members  x, v and the states are known by their names everywhere, and not declared in `start`
/// throws  Unable  when a stage stays implicit
CodeStep code_step_of_class(const Program& program, const Values& parameters, Language language,
                            bool members);

}  // namespace shortfall
