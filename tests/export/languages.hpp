// SPDX-License-Identifier: GPL-3.0-or-later
// Printed code is compiled and run where its language is installed.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/scratch_folder.hpp"

namespace shortfall {

namespace fs = std::filesystem;

inline bool installed(const std::string& tool) {
  const bool found = std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0;
  if (!found) MESSAGE("skipped: " << tool << " is not installed");
  return found;
}

/// A folder in which printed code is compiled and run.
struct CodeFolder : ScratchFolder {
  /// What a command says, both ways; it must succeed.
  std::string output(const std::string& command) const {
    const int code = std::system(("cd " + root().string() + " && (" + command + ") > output 2>&1").c_str());
    std::string said = text("output");
    CHECK_MESSAGE(code == 0, command << "\n" << said);
    return said;
  }
};

}  // namespace shortfall
