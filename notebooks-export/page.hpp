// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// A derivation as a page: the answer, a figure to explore, the derivation line by line, the corrections or
/// why there are none, the integrator's text, code.
///
/// param   program  what was derived, without the substeps of the derivation
/// param   sources  code that is shown in tabs: what it is called, and its text
/// param   motion   of the figure, from explorer_motion; none when it is empty
/// param   command  what makes this page
std::string page(const Program& program, const Derivation& derivation, const CorrectionKit& kit,
                 const std::vector<std::pair<std::string, std::string>>& sources, const std::string& motion,
                 const std::string& command);

/// The object `motion` of the figure to explore: the closed forms as functions of JavaScript.
///
/// param   derivation  with numbers for all parameters
/// throws  Unable  when a formula cannot be written
std::string explorer_motion(const Derivation& derivation, const CorrectionKit& kit);
/// Its sliders and the places of its drawings.
std::string explorer_markup(const Derivation& derivation, bool correctable);

}  // namespace shortfall
