// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/house/source_files.hpp"

namespace shortfall::house {
namespace {

// From the bottom upwards. A file may include what stands in its own layer or before it.
const std::vector<std::string_view> kLayers = {
    "analysis/algebra/",
    "analysis/program/",
    "analysis/problems/",
    "analysis/motion/",
    "analysis/series/",
    "analysis/stability/",
    "analysis/correction/",
    "analysis/audit/",
    "analysis/floating/",
    "native/",  // written by the build
    "analysis/native/",
    "analysis/trade/",
    "analysis/identify/",
    "analysis/shortfall.hpp",
    "notebooks-export/",
    "cli/",
};

/// The place of a file in kLayers.
std::optional<std::size_t> layer(std::string_view path) {
  const auto found = std::ranges::find_if(kLayers, [&](auto prefix) { return path.starts_with(prefix); });
  if (found == kLayers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kLayers.begin());
}

/// Tests, benchmarks and examples stand on top: they may include everything.
bool is_on_top(std::string_view path) {
  return path.starts_with("tests/") || path.starts_with("bench/") || path.starts_with("examples/") ||
         path.starts_with("fuzz/") || path.starts_with("cmake/");
}

/// The file named by an #include "..." line.
std::optional<std::string_view> included(std::string_view line) {
  if (!line.starts_with("#include")) return std::nullopt;
  const std::size_t open = line.find('"');
  const std::size_t close = line.rfind('"');
  if (open == close) return std::nullopt;
  return line.substr(open + 1, close - open - 1);
}

/// A sentence for every #include that breaks the order of the layers.
std::vector<std::string> upward_includes(const SourceFile& file) {
  std::vector<std::string> findings;
  if (is_on_top(file.path)) return findings;
  const auto own = layer(file.path);
  if (!own) return {file.path + ": lies in no layer that this test knows"};
  const std::string text = code(file.text);
  int number = 0;
  for (std::string_view line : lines(text)) {
    ++number;
    const auto target = included(line);
    if (!target) continue;
    const auto theirs = layer(*target);
    const std::string where = file.path + ":" + std::to_string(number) + ": ";
    if (!theirs) {
      findings.push_back(where + std::string(*target) +
                         " does not start at the root, or lies in no known layer");
    } else if (*theirs > *own) {
      findings.push_back(where + std::string(*target) + " lies in a higher layer");
    }
  }
  return findings;
}

/// A sentence for every line that can print, below the command line.
std::vector<std::string> printing(const SourceFile& file) {
  std::vector<std::string> findings;
  if (is_on_top(file.path) || file.path.starts_with("cli/")) return findings;
  if (file.path.find("/generator/") != std::string::npos) return findings;  // a program that the build runs
  const std::string text = code(file.text);
  int number = 0;
  for (std::string_view line : lines(text)) {
    ++number;
    for (std::string_view word :
         {"<iostream>", "<print>", "std::cout", "std::cerr", "std::clog", "std::puts", " puts(",
          "printf(stdout", "printf(stderr", "std::printf", " printf(", "fmt::print"}) {
      if (line.find(word) != std::string_view::npos) {
        findings.push_back(file.path + ":" + std::to_string(number) + ": only cli prints, here is " +
                           std::string(word));
      }
    }
  }
  return findings;
}

/// A sentence when the file lacks its licence, or is too long to hold one idea.
std::vector<std::string> untidiness(const SourceFile& file) {
  std::vector<std::string> findings;
  std::string_view start = file.text;
  if (start.starts_with("#!")) start.remove_prefix(std::min(start.find('\n') + 1, start.size()));
  start.remove_prefix(start.starts_with("//") ? 2 : start.starts_with("#") ? 1 : 0);
  if (!start.starts_with(" SPDX-License-Identifier: GPL-3.0-or-later\n"))
    findings.push_back(file.path + ": does not start with the SPDX line");
  const std::size_t length = lines(file.text).size();
  if (length > 400)
    findings.push_back(file.path + ": has " + std::to_string(length) + " lines, 400 is the limit");
  return findings;
}

template <class Check>
void check_everywhere(Check check, const std::vector<SourceFile>& files = source_files()) {
  REQUIRE(files.size() > 5);
  for (const SourceFile& file : files) {
    for (const std::string& finding : check(file)) FAIL_CHECK(finding);
  }
}

TEST_CASE("no file includes one from a higher layer") { check_everywhere(upward_includes); }

TEST_CASE("only the command line prints") { check_everywhere(printing); }

TEST_CASE("every source file names its licence and stays under 400 lines") {
  check_everywhere(untidiness);
  check_everywhere(untidiness, scripts());
}

TEST_CASE("an upward include is found") {
  const auto findings =
      upward_includes({"analysis/algebra/planted.hpp",
                       "#pragma once\n#include <vector>\n#include \"analysis/program/parse.hpp\"\n"});
  REQUIRE(findings.size() == 1);
  CHECK(findings[0] == "analysis/algebra/planted.hpp:3: analysis/program/parse.hpp lies in a higher layer");
  CHECK(upward_includes({"analysis/motion/x.cpp", "#include \"analysis/correction/kit.hpp\"\n"}).size() == 1);
  CHECK(upward_includes({"notebooks-export/x.cpp", "#include \"cli/options.hpp\"\n"}).size() == 1);
  CHECK(upward_includes({"analysis/problems/x.cpp", "#include \"analysis/shortfall.hpp\"\n"}).size() == 1);
}

TEST_CASE("an include that hides its layer is found") {
  CHECK(upward_includes({"analysis/algebra/x.cpp", "#include \"../program/parse.hpp\"\n"}).size() == 1);
  CHECK(upward_includes({"analysis/algebra/x.cpp", "#include \"rational.hpp\"\n"}).size() == 1);
  CHECK(upward_includes({"analysis/unheard-of/x.cpp", ""}).size() == 1);
}

TEST_CASE("downward includes, comments and strings are let pass") {
  const std::string text =
      "// #include \"cli/main.hpp\"\n"
      "#include \"analysis/algebra/rational.hpp\"\n"
      "#include \"analysis/motion/own.hpp\"\n"
      "/*\n#include \"cli/main.hpp\"\n*/\n"
      "const char* page = R\"cpp(\n#include \"cli/main.hpp\"\nstd::cout << 1;\n)cpp\";\n"
      "const int large = 1'000'000; const char quote = '\"';\n";
  CHECK(upward_includes({"analysis/motion/x.cpp", text}).empty());
  CHECK(printing({"analysis/motion/x.cpp", text}).empty());
}

TEST_CASE("printing below the command line is found") {
  CHECK(printing({"analysis/motion/x.cpp", "#include <iostream>\n"}).size() == 1);
  CHECK(printing({"notebooks-export/x.cpp", "void f() { std::cout << 1; }\n"}).size() == 1);
  CHECK(printing({"analysis/motion/x.cpp", "const int n = 1'000; void f() { std::cerr << 'x'; }\n"}).size() ==
        1);
  CHECK(printing({"cli/x.cpp", "#include <iostream>\n"}).empty());
}

TEST_CASE("a missing licence and a long file are found") {
  const std::string licence = "// SPDX-License-Identifier: GPL-3.0-or-later\n";
  CHECK(untidiness({"cli/x.cpp", "int x;\n"}).size() == 1);
  CHECK(untidiness({"lessons/x.py", "#!/usr/bin/env python3\n#" + licence.substr(2)}).empty());
  CHECK(untidiness({"lessons/x.py", "#!/usr/bin/env python3\n"}).size() == 1);
  CHECK(untidiness({"cli/x.cpp", licence + std::string(400, '\n')}).size() == 1);
  CHECK(untidiness({"cli/x.cpp", licence + std::string(399, '\n')}).empty());
}

}  // namespace
}  // namespace shortfall::house
