// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/jump_flight.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// A file with the corrected jump: the launch velocity for a height, the one that puts the top on a frame,
/// the step that it is for, and a check of itself. Height, gravity and dt are arguments; g and dt given here
/// become their defaults.
///
/// param   height  what the check jumps to; some usual heights otherwise
/// throws  Undefined  when no launch correction exists, with the reason;  Unable  when the step cannot be
/// written
std::string jump_code(const Flight& flight, const Rational& g, Language language,
                      const std::optional<Rational>& height = std::nullopt);

/// A function of numbers in another language.
struct CodeFunction {
  std::string name;                    ///< snake_case; becomes the language's habit
  std::vector<std::string> about;      ///< lines of its comment
  std::vector<std::string> arguments;  ///< names of the formula's letters; h becomes dt
  Expr value;
};
std::string code(const CodeFunction& function, Language language);
/// What the function is called there: launchVelocity, LaunchVelocity, launch_velocity.
std::string code_name(const CodeFunction& function, Language language);

}  // namespace shortfall
