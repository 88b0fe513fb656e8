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
};

/// Under a constant acceleration (ForceInCode::constant) the places where the force is evaluated do not
/// matter; what only serves to find them is left out, and implicit stages become explicit.
///
/// throws  Unable  when a stage stays implicit, or the step reads the clock under a constant force
CodeStep code_step(const Program& program, const Values& parameters, Language language,
                   ForceInCode force = ForceInCode::constant);

}  // namespace shortfall
