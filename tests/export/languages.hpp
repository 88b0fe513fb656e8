// SPDX-License-Identifier: GPL-3.0-or-later
// Printed code is compiled and run where its language is installed.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace shortfall {

namespace fs = std::filesystem;

inline bool installed(const std::string& tool) {
  const bool found = std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0;
  if (!found) MESSAGE("skipped: " << tool << " is not installed");
  return found;
}

/// A folder that goes away.
struct CodeFolder {
  fs::path path = [] {
    std::string name = (fs::temp_directory_path() / "shortfall-code-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    return fs::path(name);
  }();
  ~CodeFolder() { fs::remove_all(path); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }

  /// What a command says, both ways; it must succeed.
  std::string output(const std::string& command) const {
    const std::string out = (path / "output").string();
    const int code = std::system(("cd " + path.string() + " && (" + command + ") > output 2>&1").c_str());
    std::ifstream in(out);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    CHECK_MESSAGE(code == 0, command << "\n" << text);
    return text;
  }
};

}  // namespace shortfall
