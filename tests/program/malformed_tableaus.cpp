// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <fstream>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/program/file_text.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/tableau_file.hpp"
#include "tests/program/malformed_file.hpp"

using namespace shortfall;
using testing::expected, testing::files_of;

namespace {

namespace fs = std::filesystem;

const fs::path kData = fs::path(SHORTFALL_SOURCE_DIR) / "tests/data";

std::string tableau_complaint(const fs::path& file) {
  return testing::complaint_of([&] { parse_tableau(file_text(file.string()), file.filename().string()); });
}

}  // namespace

TEST_CASE("every malformed tableau is refused with its message, in its place") {
  const std::vector<fs::path> files = files_of(kData / "malformed-tableaus", ".json");
  CHECK(files.size() >= 100);
  for (const fs::path& file : files) {
    CAPTURE(file.filename().string());
    CHECK(tableau_complaint(file) == file_text(expected(file).string()));
  }
}

TEST_CASE("the expected messages of the malformed tableaus are written anew" * doctest::skip()) {
  for (const fs::path& file : files_of(kData / "malformed-tableaus", ".json")) {
    CAPTURE(file.filename().string());
    const std::string text = tableau_complaint(file);
    CHECK(text != "accepted\n");
    std::ofstream(expected(file), std::ios::binary) << text;
  }
}

TEST_CASE("a line of 100,000 bytes is read, a longer one and a file of over 1 MB are refused") {
  const auto with_note = [](std::size_t length) {
    return R"({"A": [[0]], "b": [1], "note": ")" + std::string(length, 'n') + "\"}";
  };
  CHECK(parse_tableau(with_note(99'000), "long.json").note.size() == 99'000);
  CHECK_THROWS_WITH_AS(parse_tableau(with_note(100'000), "long.json"),
                       "long.json:1:1: the line is longer than 100,000 bytes", SyntaxError);
  CHECK_THROWS_AS(parse_tableau(with_note(10) + std::string(1'000'000, '\n'), "long.json"), SyntaxError);
}

TEST_CASE("five hundred stages in full are refused at once") {
  std::string row = "[0";
  for (int i = 1; i < 500; ++i) row += ",0";
  row += "]";
  std::string text = "{\"A\": [" + row;
  for (int i = 1; i < 500; ++i) text += ",\n" + row;
  CHECK_THROWS_WITH_AS(parse_tableau(text + "],\n\"b\": " + row + "}", "large.json"),
                       "large.json:501:6: the tableau has 500 stages; at most 64 are read", SyntaxError);
}

TEST_CASE("a tableau with some bytes changed is read or refused with a place, whatever they are") {
  std::mt19937 rng(20240607);
  const std::vector<fs::path> files = files_of(kData / "methods", ".json");
  const std::string bytes = "[]{},:\"\\/.0123456789-+eE*^()# \n\tsqrtxnul\xC3\xA4";
  int read = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = file_text(files[rng() % files.size()].string());
    for (int k = 1 + static_cast<int>(rng() % 3); k > 0; --k) {
      const std::size_t at = rng() % text.size();
      const char byte = bytes[rng() % bytes.size()];
      switch (rng() % 4) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        case 2:
          text.erase(at, 1 + rng() % 5);
          break;
        default:
          text.resize(at);
      }
      if (text.empty()) text = " ";
    }
    try {
      const TableauFile file = parse_tableau(text, "mutated.json");
      CHECK(file.a.size() == file.stages());
      CHECK(file.c.size() == file.stages());
      CHECK(!file.program.step.empty());
      CAPTURE(text);
      CHECK(same(parse(print(file.program), "printed.integrator"), file.program));
      ++read;
    } catch (const SyntaxError& e) {
      CAPTURE(e.what());
      CHECK(e.line() >= 1);
      CHECK(e.column() >= 1);
      ++refused;
    }
  }
  CHECK(read > 300);
  CHECK(refused > 300);
}
