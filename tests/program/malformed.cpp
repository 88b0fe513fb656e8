// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(SHORTFALL_SOURCE_DIR) / "tests/data/malformed";

std::vector<fs::path> inputs() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == ".integrator") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What a user reads: the message, and the line with the caret.
std::string complaint(const fs::path& file) {
  try {
    parse(contents(file), file.filename().string());
    return "accepted\n";
  } catch (const SyntaxError& e) {
    const std::string context = e.context();
    return std::string(e.what()) + "\n" + (context.empty() ? "" : context + "\n");
  }
}

fs::path expected(fs::path file) { return file.replace_extension(".expected"); }

}  // namespace

TEST_CASE("every malformed file is refused with its message, in its place") {
  CHECK(inputs().size() >= 254);
  for (const fs::path& file : inputs()) {
    CAPTURE(file.filename().string());
    CHECK(complaint(file) == contents(expected(file)));
  }
}

TEST_CASE("the expected messages of the malformed files are written anew" * doctest::skip()) {
  for (const fs::path& file : inputs()) {
    const std::string text = complaint(file);
    CHECK(text != "accepted\n");
    std::ofstream(expected(file), std::ios::binary) << text;
  }
}
