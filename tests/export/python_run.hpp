// SPDX-License-Identifier: GPL-3.0-or-later
// A scratch folder, and Python to run what was exported into it.
#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/scratch_folder.hpp"

namespace shortfall {

namespace fs = std::filesystem;

/// The path of a file in it, as a shell reads it.
inline std::string quoted(const ScratchFolder& folder, const std::string& file) {
  return "'" + folder.path(file) + "'";
}

struct ShellRun {
  int code = -1;
  std::string output;
};

inline ShellRun shell_run(const std::string& command) {
  ShellRun outcome;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> block;
  for (std::size_t size; (size = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
    outcome.output.append(block.data(), size);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return outcome;
}

/// A virtual environment's Python, otherwise the system's, which has Debian's matplotlib and Jupyter where
/// they are installed, whatever a version manager puts first; "" when there is none.
inline std::string python() {
  std::vector<std::string> candidates{"/usr/bin/python3", "python3"};
  if (const char* venv = std::getenv("VIRTUAL_ENV"))
    candidates.insert(candidates.begin(), std::string(venv) + "/bin/python3");
  for (const std::string& candidate : candidates)
    if (shell_run("'" + candidate + "' -c 'import fractions'").code == 0) return candidate;
  return "";
}

}  // namespace shortfall
