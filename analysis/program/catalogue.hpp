// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// The integrators that come with shortfall, sorted by family and name.
const std::vector<Program>& catalogue();

/// The family of a catalogue integrator, from its folder: "euler", "verlet", ...
std::string family(const Program& program);

/// The integrator a user means: a name or an alias of the catalogue (case, blanks and hyphens do not matter),
/// an engine with its version, "rapier@0.21" (version.hpp), or the path of a file.
///
/// throws  BadInput  for an unknown name, with a suggestion, or version; SyntaxError from a file
Program find_integrator(const std::string& word);

/// What find_integrator finds it again by: the name of one of ours, otherwise the path of its file.
std::string word_for(const Program& program);

}  // namespace shortfall
