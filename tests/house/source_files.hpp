// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shortfall::house {

struct SourceFile {
  std::string path;  ///< from the repository's root, with forward slashes
  std::string text;
};

/// Every .cpp and .hpp of the project, sorted by path.
std::vector<SourceFile> source_files();

/// Every Python, shell and CMake script of the project, in the same way.
std::vector<SourceFile> scripts();

/// The lines of a text, without their ends.
std::vector<std::string_view> lines(std::string_view text);

/// The text with comments, characters and strings blanked, except in #include lines: what the compiler acts
/// upon. Lines keep their places, so that a finding can be reported with its number.
std::string code(std::string_view text);

}  // namespace shortfall::house
