// SPDX-License-Identifier: GPL-3.0-or-later
// Every integrator as a class of every language: compiled and run where the language is installed, all of
// them in one program, and compared with shortfall's own run to the last bit.
#include "notebooks-export/code_class.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/first_steps.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/cpp_names.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/transform.hpp"
#include "tests/export/languages.hpp"

namespace shortfall {
namespace {

constexpr int kSteps = 20;

struct SubsteppedProgram {
  Program program;
  int substeps = 1;
};

bool can_be_written(const Program& p) {
  try {
    integrator_code(p, {}, 1, Language::python);
    return true;
  } catch (const Unable&) {  // a stage stays implicit
    return false;
  }
}

/// What of the catalogue is explicit, one with substeps, and one with names that are taken elsewhere.
const std::vector<SubsteppedProgram>& written_programs() {
  static const std::vector<SubsteppedProgram> all = [] {
    std::vector<SubsteppedProgram> list;
    for (const Program& p : catalogue())
      if (can_be_written(p)) list.push_back({p});
    Program fine = find_integrator("velocity-verlet");
    fine.name = "fine-verlet";
    list.push_back({fine, 3});
    list.push_back({parse(
        "integrator odd-names\n  param lambda = 1/3\n  param alpha_m = 1 - lambda\n  state while : L/T\n"
        "start\n  top = h*a(x, v, t)\n  while = v + top\n"
        "step\n  def = a(x, v, t)\n  v = v + h*def\n  x = x + h*(lambda*while + alpha_m*v)\n"
        "  while = v\n"
        "finish\n  x = x + 0.1*h*v\n  v = 0.3*v\n",
        "odd.integrator")});
    return list;
  }();
  return all;
}

std::string class_code(const SubsteppedProgram& s, Language language) {
  return integrator_code(s.program, {}, s.substeps, language);
}
std::string name_of(const SubsteppedProgram& s) { return cpp_class_name(s.program.name); }

std::string without(std::string text, const std::string& line) {
  for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos;) text.erase(at, line.size());
  return text;
}

/// Numbers as they are printed, x and v after each step, of one sample after the other; then 1 for its
/// self-check.
void compare_steps(const std::string& output, bool binary32, const auto& read, double tolerance = 0) {
  std::istringstream in(output);
  for (const SubsteppedProgram& s : written_programs()) {
    CAPTURE(s.program.name);
    const Program whole = s.substeps == 1 ? s.program : substepped(s.program, s.substeps);
    const FirstSteps wanted = first_steps(whole, {}, binary32, kSteps);
    bool same = true;
    for (int k = 0; k < kSteps; ++k) {
      const auto i = static_cast<std::size_t>(k);
      std::string x, v;
      REQUIRE(bool(in >> x >> v));
      if (!(std::abs(read(x) - wanted.x[i]) <= tolerance && std::abs(read(v) - wanted.v[i]) <= tolerance)) {
        if (same)
          FAIL_CHECK("step " << k + 1 << ": " << x << " " << v << ", not " << wanted.x[i] << " "
                             << wanted.v[i]);
        same = false;
      }
    }
    std::string check;
    REQUIRE(bool(in >> check));
    CHECK(check == "1");
  }
}

double of_decimal(const std::string& text) { return std::stod(text); }
double of_binary32(const std::string& text) { return static_cast<double>(std::stof(text)); }

TEST_CASE("nearly all of the catalogue can be written") { CHECK(written_programs().size() >= 45); }

TEST_CASE("integrators as classes of C++ compile without a warning and have the bits of shortfall") {
  if (!installed("g++")) return;
  const CodeFolder folder;
  std::string text = "#include <cstdio>\n#include <functional>\n";
  std::string main =
      "int main() {\n  const auto force = [](float x, float v, float t) { return t - 2.0f * x - 0.25f * v; "
      "};\n";
  for (const SubsteppedProgram& s : written_programs()) {
    text += without(class_code(s, Language::cpp), "#pragma once\n");
    std::string function = s.program.name;
    for (char& c : function)
      if (c == '-') c = '_';
    main += "  { " + name_of(s) +
            "<std::function<float(float, float, float)>> b(force, 0.5f, -0.75f, 0.1f);\n    for (int k = 0; "
            "k < " +
            std::to_string(kSteps) +
            "; ++k) { b.step(); const auto [x, v] = b.read_out(); std::printf(\"%.9g %.9g\\n\", x, v); }\n" +
            "    std::printf(\"%d\\n\", " + function + "_self_check()); }\n";
  }
  folder.write("all.cpp", text + main + "}\n");
  folder.output(
      "g++ -std=c++17 -O1 -Wall -Wextra -Wpedantic -Wno-unused-variable -Werror -ffp-contract=off -o all "
      "all.cpp");
  compare_steps(folder.output("./all"), true, of_binary32);
}

TEST_CASE("integrators as classes of Rust") {
  if (!installed("rustc")) return;
  const CodeFolder folder;
  std::string text = "#![allow(dead_code)]\n", main = "fn main() {\n";
  for (std::size_t k = 0; k < written_programs().size(); ++k) {
    const std::string space = "m" + std::to_string(k);
    text += "mod " + space + " {\n" + class_code(written_programs()[k], Language::rust) + "}\n";
    main += "  { let mut b = " + space + "::" + name_of(written_programs()[k]) +
            "::new(|x, v, t| t - 2.0 * x - 0.25 * v, 0.5, -0.75, 0.1);\n    for _ in 0.." +
            std::to_string(kSteps) +
            " { b.step(); let (x, v) = b.read_out(); println!(\"{} {}\", x, v); }\n    println!(\"1\"); }\n";
  }
  folder.write("all.rs", text + main + "}\n");
  folder.output("rustc --edition 2021 -D warnings -A unused-assignments -o all all.rs");
  compare_steps(folder.output("./all"), true, of_binary32);
  folder.output("rustc --edition 2021 -A unused-assignments --test -o all-test all.rs && ./all-test");
}

TEST_CASE("integrators as classes of C#") {
  if (!installed("mcs") || !installed("mono")) return;
  const CodeFolder folder;
  std::string text = "using System;\n", main = "static class Program { static void Main() { float x, v;\n";
  for (const SubsteppedProgram& s : written_programs()) {
    text += without(class_code(s, Language::csharp), "using System;\n");
    main += "{ var b = new " + name_of(s) +
            "((p, q, t) => t - 2.0f * p - 0.25f * q, 0.5f, -0.75f, 0.1f); for (int k = 0; k < " +
            std::to_string(kSteps) +
            "; ++k) { b.Step(); b.ReadOut(out x, out v); Console.WriteLine(\"{0:R} {1:R}\", x, v); } "
            "Console.WriteLine(" +
            name_of(s) + ".SelfCheck() ? 1 : 0); }\n";
  }
  folder.write("all.cs", text + main + "} }\n");
  folder.output("mcs -out:all.exe all.cs");
  compare_steps(folder.output("mono all.exe"), true, of_binary32);
}

TEST_CASE("integrators as classes of Python") {
  if (!installed("python3")) return;
  const CodeFolder folder;
  std::string text;
  for (const SubsteppedProgram& s : written_programs())
    text += class_code(s, Language::python) + "b = " + name_of(s) +
            "(lambda x, v, t: t - 2.0 * x - 0.25 * v, 0.5, -0.75, 0.1)\nfor _ in range(" +
            std::to_string(kSteps) +
            "):\n    b.step()\n    print(*map(repr, b.read_out()))\nprint(int(self_check()))\n";
  folder.write("all.py", text);
  compare_steps(folder.output("python3 all.py"), false, of_decimal);
}

TEST_CASE("integrators as classes of JavaScript") {
  if (!installed("node")) return;
  const CodeFolder folder;
  std::string text = "\"use strict\";\n";
  for (const SubsteppedProgram& s : written_programs())
    text += "{\n" + class_code(s, Language::javascript) + "const b = new " + name_of(s) +
            "((x, v, t) => t - 2 * x - 0.25 * v, 0.5, -0.75, 0.1);\nfor (let k = 0; k < " +
            std::to_string(kSteps) +
            "; ++k) { b.step(); console.log(...b.readOut()); }\nconsole.log(Number(" + name_of(s) +
            ".selfCheck()));\n}\n";
  folder.write("all.js", text);
  compare_steps(folder.output("node all.js"), false, of_decimal);
}

/// The last eight bytes that Godot makes of a number; it says 32 bits where these are enough.
double of_godot(const std::string& hex) {
  const auto bytes = [&](std::size_t from, int count) {
    std::uint64_t value = 0;
    for (int k = count - 1; k >= 0; --k)
      value = value << 8U | std::stoul(hex.substr(from + 2 * static_cast<std::size_t>(k), 2), nullptr, 16);
    return value;
  };
  if (hex.size() == 24) return std::bit_cast<double>(bytes(8, 8));
  return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bytes(8, 4))));
}

TEST_CASE("integrators as classes of GDScript") {
  if (!installed("godot3-server")) return;
  const CodeFolder folder;
  std::string main =
      "extends SceneTree\n\nfunc bits(value: float) -> String:\n\treturn "
      "var2bytes(value).hex_encode()\n\nfunc _init():\n"
      "\tfor k in range(" +
      std::to_string(written_programs().size()) +
      "):\n"
      "\t\tvar b = load(\"res://own%d.gd\" % k).new()\n\t\tb.begin(0.5, -0.75, 0.1)\n"
      "\t\tfor _k in range(" +
      std::to_string(kSteps) +
      "):\n\t\t\tb.step()\n\t\t\tvar shown = b.read_out()\n"
      "\t\t\tprint(bits(shown[0]), \" \", bits(shown[1]))\n\t\tprint(1 if b.self_check() else 0)\n\tquit()\n";
  for (std::size_t k = 0; k < written_programs().size(); ++k) {
    const std::string number = std::to_string(k);
    folder.write("c" + number + ".gd", class_code(written_programs()[k], Language::gdscript));
    folder.write("own" + number + ".gd",
                 "extends \"res://c" + number +
                     ".gd\"\n\nfunc acceleration(x: float, v: float, t: float) -> float:\n"
                     "\treturn t - 2.0 * x - 0.25 * v\n");
  }
  folder.write("main.gd", main);
  folder.write("project.godot", "config_version=4\n");
  std::string text = folder.output("HOME=. timeout 60 godot3-server --no-window --script main.gd");
  // Behind its banner.
  for (std::size_t end = 0; !text.empty() && !text.starts_with("0300"); text.erase(0, end))
    end = text.find('\n') + 1;
  // Godot 3 reads long decimals to the last bit but one or two, and its max and min are in binary32.
  compare_steps(text, false, of_godot, 1e-6);
}

TEST_CASE("a class says what it gets wrong, and an implicit stage is refused with the reason") {
  const std::string text = integrator_code(find_integrator("symplectic-euler"), {}, 1, Language::csharp);
  CHECK(text.find("exact minus computed after a time t is -1/2*a*dt*t for x and 0 for v") !=
        std::string::npos);
  CHECK(text.find("launch: -1/2*a*dt added to v0 repairs it") != std::string::npos);
  CHECK(text.find("class SymplecticEuler\n") != std::string::npos);
  CHECK_THROWS_AS(integrator_code(find_integrator("gauss4"), {}, 1, Language::python), Unable);
  for (const std::string& word : language_names())
    CHECK(integrator_code(find_integrator("box2d"), {}, 1, *language_named(word)).find('@') ==
          std::string::npos);
}

}  // namespace
}  // namespace shortfall
