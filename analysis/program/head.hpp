// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

/// The words that open a declaration at the head of a file.
const std::vector<std::string>& head_words();

/// Reads what follows such a word (all but alias and source, which are plain text) to the end of its
/// statement.
///
/// throws  SyntaxError
void read_declaration(Program& program, const std::string& word, TokenReader& in, Place place);

}  // namespace shortfall
