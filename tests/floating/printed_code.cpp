// SPDX-License-Identifier: GPL-3.0-or-later
// Code that is handed over, compiled, makes the same bits as the run that a budget is about.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "analysis/algebra/surd.hpp"
#include "analysis/floating/budget.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/scratch_folder.hpp"

using namespace shortfall;

namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("compiled float code of correct --lang cpp has the bits of the budget's run") {
  if (std::system("c++ --version > /dev/null 2>&1") != 0) {
    MESSAGE("left out: no compiler is called c++ here");
    return;
  }
  const ScratchFolder folder;
  const fs::path& path = folder.root();
  const std::vector<std::string> names{"symplectic-euler", "velocity-verlet", "rk4", "position-verlet",
                                       "leapfrog"};
  const std::vector<std::pair<std::string, Rational>> heights{
      {"1.7", {17, 10}}, {"0.4", {2, 5}}, {"23.3", {233, 10}}};

  // One program for all: each header in a namespace of its own.
  std::string source = "#include <algorithm>\n#include <cmath>\n#include <cstdio>\n", calls;
  for (const std::string& name : names) {
    std::string space = name;
    std::ranges::replace(space, '-', '_');
    const std::string command = std::string("'") + SHORTFALL_BINARY + "' correct " + name +
                                " --force constant --lang cpp --dt 0.02 > '" + (path / "code.hpp").string() +
                                "' 2>/dev/null";
    if (std::system(command.c_str()) != 0) continue;
    std::string code = file_text(path / "code.hpp");
    for (const char* line : {"#pragma once", "#include <algorithm>", "#include <cmath>"})
      if (const auto at = code.find(line); at != std::string::npos) code.erase(at, std::string(line).size());
    source += "namespace " + space + " {\n" + code + "\n}\n";
    for (const auto& [text, height] : heights) {
      const float launch = Surd::sqrt(Rational(2) * Rational(981, 100) * height).approximation(60).to_float();
      std::array<char, 64> hex{};
      std::snprintf(hex.data(), hex.size(), "%a", static_cast<double>(launch));
      calls += "  std::printf(\"" + name + " " + text + " %a\\n\", static_cast<double>(" + space +
               "::jump::highest_frame(" + hex.data() + "f)));\n";
    }
  }
  std::ofstream(path / "bits.cpp") << source << "int main() {\n" << calls << "}\n";
  const std::string compile =
      "cd '" + path.string() + "' && c++ -std=c++17 -O2 -ffp-contract=off bits.cpp -o bits && ./bits > out";
  REQUIRE(std::system(compile.c_str()) == 0);

  std::ifstream out(path / "out");
  int compared = 0;
  for (std::string name, text, bits; out >> name >> text >> bits; ++compared) {
    CAPTURE(name);
    CAPTURE(text);
    FloatQuestion q;
    q.program = find_integrator(name);
    q.h = Rational(1, 50);
    const Budget b = peak_budget(float_format("f32"), q, Rational::parse(text), Rational(981, 100));
    CHECK(b.lines.at(0).computed.value == Rational::from_double(std::strtod(bits.c_str(), nullptr)));
  }
  CHECK(compared >= 9);
}
