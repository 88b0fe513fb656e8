// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files that must be refused; beside each stands what a user then reads.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall::testing {

/// Those of a folder with this ending, in the order of their names.
inline std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder,
                                                   const std::string& ending) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ending) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

inline std::filesystem::path expected(std::filesystem::path file) {
  return file.replace_extension(".expected");
}

/// What a user reads when a file is read so: the message, and the line with the caret.
template <class Reading>
std::string complaint_of(Reading&& reading) {
  try {
    reading();
    return "accepted\n";
  } catch (const SyntaxError& e) {
    const std::string context = e.context();
    return std::string(e.what()) + "\n" + (context.empty() ? "" : context + "\n");
  }
}

}  // namespace shortfall::testing
