// SPDX-License-Identifier: GPL-3.0-or-later
// The corrections for forces that grow with time, as functions of six languages: compiled, run, checked by
// themselves; and by Python held against the kit.
#include "notebooks-export/code_kit.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "analysis/program/catalogue.hpp"
#include "tests/export/languages.hpp"

namespace shortfall {
namespace {

struct KitCase {
  const char* integrator;
  int degree;
  int substeps = 1;
};
const std::vector<KitCase> kCases = {
    {"newmark", 2},  {"symplectic-euler", 1},    {"explicit-euler", 2},   {"velocity-verlet", 3},
    {"leapfrog", 2}, {"symplectic-euler", 2, 4}, {"adams-bashforth-2", 1}};

std::string code_of(const KitCase& c, Language language) {
  const Derivation d = derivation(find_integrator(c.integrator), c.degree, {}, c.substeps);
  return kit_code(correction_kit(d), d, language);
}

std::string repeated_line(std::size_t count, const std::string& yes) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += yes + "\n";
  return text;
}

TEST_CASE("kits in C++ compile without a warning and pass their own check") {
  if (!installed("g++")) return;
  const CodeFolder folder;
  std::string text = "#include <cstdio>\n", main = "int main() {\n";
  for (std::size_t k = 0; k < kCases.size(); ++k) {
    const std::string space = "kit" + std::to_string(k);
    text += "namespace " + space + " {\n" + code_of(kCases[k], Language::cpp) + "}\n";
    main += "  std::puts(" + space + "::self_check() ? \"yes\" : \"no\");\n";
  }
  folder.write("kit.cpp", text + main + "}\n");
  folder.output("g++ -std=c++17 -Wall -Wextra -Wpedantic -Wno-unused-parameter -Werror -o kit kit.cpp");
  CHECK(folder.output("./kit") == repeated_line(kCases.size(), "yes"));
}

TEST_CASE("kits in Rust compile and pass their own check, and their own tests") {
  if (!installed("rustc")) return;
  const CodeFolder folder;
  std::string text = "#![allow(dead_code)]\n", main = "fn main() {\n";
  for (std::size_t k = 0; k < kCases.size(); ++k) {
    const std::string space = "kit" + std::to_string(k);
    text += "mod " + space + " {\n" + code_of(kCases[k], Language::rust) + "}\n";
    main += "    println!(\"{}\", if " + space + "::self_check() { \"yes\" } else { \"no\" });\n";
  }
  folder.write("kit.rs", text + main + "}\n");
  folder.output("rustc --edition 2021 -A unused-variables -D warnings -o kit kit.rs");
  CHECK(folder.output("./kit") == repeated_line(kCases.size(), "yes"));
  folder.output("rustc --edition 2021 --test -o kit-test kit.rs && ./kit-test");
}

TEST_CASE("kits in C# compile and pass their own check") {
  if (!installed("mcs") || !installed("mono")) return;
  const CodeFolder folder;
  std::string text = "using System;\n", main = "static class Program { static void Main() {\n";
  for (std::size_t k = 0; k < kCases.size(); ++k) {
    std::string code = code_of(kCases[k], Language::csharp);
    const std::string space = "Correction" + std::to_string(k);
    code.replace(code.find("class Correction"), 16, "class " + space);
    text += code;
    main += "Console.WriteLine(" + space + ".SelfCheck() ? \"yes\" : \"no\");\n";
  }
  folder.write("kit.cs", text + main + "} }\n");
  folder.output("mcs -out:kit.exe kit.cs");
  CHECK(folder.output("mono kit.exe") == repeated_line(kCases.size(), "yes"));
}

TEST_CASE("kits in JavaScript pass their own check") {
  if (!installed("node")) return;
  const CodeFolder folder;
  std::string main;
  for (const KitCase& c : kCases)
    main += "{\n" + code_of(c, Language::javascript) + "console.log(selfCheck() ? \"yes\" : \"no\");\n}\n";
  folder.write("kit.js", "\"use strict\";\n" + main);
  CHECK(folder.output("node kit.js") == repeated_line(kCases.size(), "yes"));
}

TEST_CASE("kits in GDScript pass their own check") {
  if (!installed("godot3-server")) return;
  const CodeFolder folder;
  std::string main = "extends SceneTree\n\nfunc _init():\n";
  for (std::size_t k = 0; k < kCases.size(); ++k) {
    const std::string file = "kit" + std::to_string(k) + ".gd";
    folder.write(file, code_of(kCases[k], Language::gdscript));
    main += "\tprint(\"check \", load(\"res://" + file + "\").self_check())\n";
  }
  folder.write("main.gd", main + "\tquit()\n");
  folder.write("project.godot", "config_version=4\n");
  const std::string said = folder.output("HOME=. timeout 60 godot3-server --no-window --script main.gd");
  std::size_t passed = 0;
  for (std::size_t at = 0; (at = said.find("check True", at)) != std::string::npos; ++at) ++passed;
  CHECK_MESSAGE(passed == kCases.size(), said);
}

TEST_CASE("kits in Python pass their own check; with a wrong number they do not") {
  if (!installed("python3")) return;
  const CodeFolder folder;
  for (const KitCase& c : kCases) {
    CAPTURE(c.integrator);
    const std::string code = code_of(c, Language::python);
    folder.write("kit.py", code);
    CHECK(folder.output("python3 kit.py") == "");
    std::string wrong = code;
    const std::size_t at = wrong.find("return ") + 7;
    wrong.insert(at, "0.001 + ");
    folder.write("kit.py", wrong);
    CHECK(folder.output("python3 kit.py 2>&1 | tail -n 1") == "AssertionError\n");
  }
}

TEST_CASE("a read-out of the position says which velocity it means") {
  const std::string code = code_of({"explicit-euler", 1}, Language::rust);
  CHECK(code.find("Here v is the corrected velocity.") != std::string::npos);
}

}  // namespace
}  // namespace shortfall
