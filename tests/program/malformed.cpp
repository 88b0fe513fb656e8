// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <fstream>

#include "analysis/program/file_text.hpp"
#include "analysis/program/parse.hpp"
#include "tests/program/malformed_file.hpp"

using namespace shortfall;
using testing::expected;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputs() {
  return testing::files_of(fs::path(SHORTFALL_SOURCE_DIR) / "tests/data/malformed", ".integrator");
}

std::string integrator_complaint(const fs::path& file) {
  return testing::complaint_of([&] { parse(file_text(file.string()), file.filename().string()); });
}

}  // namespace

TEST_CASE("every malformed file is refused with its message, in its place") {
  CHECK(inputs().size() >= 254);
  for (const fs::path& file : inputs()) {
    CAPTURE(file.filename().string());
    CHECK(integrator_complaint(file) == file_text(expected(file).string()));
  }
}

TEST_CASE("the expected messages of the malformed files are written anew" * doctest::skip()) {
  for (const fs::path& file : inputs()) {
    const std::string text = integrator_complaint(file);
    CHECK(text != "accepted\n");
    std::ofstream(expected(file), std::ios::binary) << text;
  }
}
