// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shortfall {

/// A named value of a line of JSON: "position.x", and the number's own text.
struct JsonCell {
  std::string name;
  std::string value;
};

/// The numbers and texts of one object of JSON lines, those of inner objects and lists under joined names
/// ("position.0").
///
/// throws  BadInput  when the line is no object
std::vector<JsonCell> json_cells(const std::string& line);

/// The cells of a row, without blanks and quotes around them. A blank separates where nothing else does.
std::vector<std::string> split_cells(std::string_view line, char separator);

/// What separates the cells of a line: a tab, a semicolon, a comma, or blanks.
char separator_of(std::string_view line);

/// Whether a text is written as a number, nan and inf included.
bool looks_like_number(std::string_view text);

}  // namespace shortfall
