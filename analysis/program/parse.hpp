// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "analysis/program/check.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// The integrator that a text in the .integrator language describes, checked.
///
/// param   file  the name that messages show
/// throws  SyntaxError  with line, column and what to write instead
Program parse(std::string_view text, const std::string& file);

/// The integrator in a file.
///
/// throws  SyntaxError; UnreadableFile
Program parse_file(const std::string& path);

/// A formula typed by a user, on one line, checked against the names it may use.
///
/// param   origin  what messages call it, such as "--x"
/// throws  SyntaxError
Expr parse_formula(std::string_view text, const std::string& origin, const Names& names, const Type& wanted);

}  // namespace shortfall
