// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/program.hpp"
#include "analysis/program/source.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

/// Reads one row of a splitting, `kick E` or `drift E`; `in` stands behind the word.
///
/// throws  SyntaxError
void read_splitting_row(Splitting& splitting, const std::string& word, TokenReader& in, Place place);

/// Turns the program's splitting into its step: a kick E is v = v + E*h*a(x, v, t + ...), a drift E is x = x
/// + E*h*v; time advances with the drifts.
///
/// throws  SyntaxError
void lower_splitting(Program& program, const Source& source);

}  // namespace shortfall
