// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/source.hpp"

namespace shortfall {

struct Token {
  enum class Kind { number, name, sign, end };
  Kind kind = Kind::end;
  std::string text;
  Place place;
};

/// The tokens from a byte of a line to the end of the statement, closed by a token of kind `end`.
///
/// A statement goes on to the next line while a parenthesis is open or after a final '&'. `line` is left at
/// the last line read.
///
/// throws  SyntaxError  at a character that is not in the language, at 2h, at a parenthesis never closed
std::vector<Token> tokens(const Source& source, int& line, std::size_t byte);

/// The tokens of a part of one line, from a byte up to another.
std::vector<Token> tokens_between(const Source& source, int line, std::size_t begin, std::size_t end);

}  // namespace shortfall
