// SPDX-License-Identifier: GPL-3.0-or-later
// Kits of linear forces as code: compiled, run, and held against the kit's certain digits for the same
// numbers.
#include "notebooks-export/linear_code.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/correction/kit_numbers.hpp"
#include "analysis/motion/own_equation.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/export/languages.hpp"

namespace shortfall {
namespace {

/// A kit in letters, and numbers for these.
struct LetteredKit {
  std::string integrator, force;
  Values letters;                             ///< of the integrator, which the class is made from
  std::vector<std::array<Rational, 3>> at{};  ///< k, c, dt; a letter that the force lacks is 0
};

const std::vector<LetteredKit>& lettered_kits() {
  const Rational tenth(1, 10), frame(1, 60);
  static const std::vector<LetteredKit> all{
      // Underdamped, critically damped, overdamped, near it, and physics that runs away.
      {"symplectic-euler",
       "damped-spring",
       {},
       {{4, Rational(1, 2), tenth},
        {4, 4, tenth},
        {1, 4, tenth},
        {40, Rational(126, 10), frame},
        {-3, Rational(1, 2), tenth}}},
      {"velocity-verlet", "spring", {}, {{4, 0, tenth}, {400, 0, frame}, {-4, 0, tenth}}},
      {"rk4", "damped-spring", {}, {{4, Rational(1, 2), tenth}, {4, 4, tenth}, {9, 10, tenth}}},
      {"newmark", "constant+spring", {{"beta", Rational(1, 6)}, {"gamma", Rational(3, 5)}}, {{4, 0, tenth}}},
      {"implicit-midpoint", "drag", {}, {{0, Rational(1, 2), tenth}, {0, 3, frame}}},
      {"yoshida4", "spring", {}, {{4, 0, tenth}}},
      {"explicit-euler", "spring:k=4", {}, {{4, 0, tenth}}},
      {"symplectic-euler", "poly:2+damped-spring", {}, {{4, Rational(1, 2), tenth}}},
  };
  return all;
}

std::string decimal_literal(const Rational& r) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", r.to_double());
  return std::string(text) + (std::string(text).find_first_of(".e") == std::string::npos ? ".0" : "");
}

LinearKit kit_of(const LetteredKit& c, const std::string& force, const Values& values) {
  return linear_kit(find_integrator(c.integrator), force_named(force), values);
}

/// Every number of a kit: what is given, and functions of one vector at a time.
struct KitMember {
  std::string member;          ///< "given_k", "launch_v0"
  std::vector<int> arguments;  ///< of a function: its unit vectors
  bool function;
  Rational expected;
};

/// The class' functions with each of their arguments 1 and the others 0, by the kit for numbers alone.
std::vector<KitMember> kit_members(const LetteredKit& c, const std::array<Rational, 3>& at) {
  std::string force = c.force;
  const std::size_t colon = force.find(":k=");
  if (colon != std::string::npos) force.erase(colon);
  const bool spring = force.find("spring") != std::string::npos,
             damper = force.find("damped") != std::string::npos || force == "drag";
  force +=
      (spring ? ":k=" + at[0].str() : std::string()) + (damper ? (spring ? ",c=" : ":c=") + at[1].str() : "");
  const LinearKit letters = kit_of(c, c.force, {});
  const LinearKit kit = kit_of(c, force, c.letters);
  const Force numbers = force_named(force);
  const KitNumbers found =
      kit_numbers(kit, numbers, parameter_values(find_integrator(c.integrator), c.letters), at[2]);
  REQUIRE(letters.corrections.size() == kit.corrections.size());
  std::vector<KitMember> result;
  for (std::size_t i = 0; i < kit.corrections.size(); ++i) {
    using Kind = LinearCorrection::Kind;
    const LinearCorrection& said = letters.corrections[i];
    const NumericCorrection& n = found.corrections[i];
    CHECK(said.target == n.target);
    const bool member = said.kind == Kind::parameter && said.target != "a" && said.target != "f";
    const char* const stem = said.kind == Kind::launch     ? "launch_"
                             : said.kind == Kind::read_out ? "shown_"
                                                           : "given_";
    std::vector<std::string> arguments;
    for (const char* vector : {"x0", "v0", "x_n", "v_n", "a", "f", "f'", "f''"})
      if (mentions(said.value, vector)) arguments.emplace_back(vector);
    if (member) {
      REQUIRE(n.terms.size() == 1);
      result.push_back({stem + said.target, {}, false, n.terms[0].first.ball.midpoint()});
      continue;
    }
    for (std::size_t k = 0; k < arguments.size(); ++k) {
      Rational value;
      for (const auto& [number, vector] : n.terms)
        if (vector == arguments[k]) value = number.ball.midpoint();
      std::vector<int> unit(arguments.size());
      unit[k] = 1;
      result.push_back({stem + said.target, unit, true, value});
    }
  }
  return result;
}

std::string class_name(const LetteredKit& c) {
  return c.force.find("damped") != std::string::npos ? "ExactDampedSpring"
         : c.force == "drag"                         ? "ExactDrag"
                                                     : "ExactSpring";
}

/// What the class is made from, in its order: k, c, the integrator's letters, dt.
std::vector<Rational> made_from(const LetteredKit& c, const std::array<Rational, 3>& at) {
  std::vector<Rational> values;
  if (c.force.find("spring") != std::string::npos && c.force.find(":k=") == std::string::npos)
    values.push_back(at[0]);
  if (c.force.find("damped") != std::string::npos || c.force == "drag") values.push_back(at[1]);
  for (const auto& [name, value] : c.letters) values.push_back(value);
  values.push_back(at[2]);
  return values;
}

std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

std::string call(const KitMember& a, Language language) {
  std::string name =
      "kit." + (language == Language::csharp && a.function ? constant_identifier(a.member, language)
                                                           : identifier(a.member, language));
  if (!a.function) return name;
  std::vector<std::string> arguments;
  for (const int unit : a.arguments) arguments.push_back(unit ? "1.0" : "0.0");
  return name + "(" + listed(arguments) + ")";
}

/// Prints what is asked, one number a line.
std::string program(const LetteredKit& c, Language language) {
  const Program integrator = find_integrator(c.integrator);
  std::string text =
      linear_kit_code(kit_of(c, c.force, {}), linear_derivation(integrator, force_named(c.force)), language);
  const std::map<Language, std::array<std::string, 5>> shapes{
      {Language::cpp,
       {"#include <cstdio>\nint main() {\n", "  { const CLASS kit(ARGS);\n",
        "    std::printf(\"%.17g\\n\", CALL);\n", "  }\n", "}\n"}},
      {Language::rust,
       {"fn main() {\n", "    { let kit = CLASS::new(ARGS);\n", "      println!(\"{:e}\", CALL);\n",
        "    }\n", "}\n"}},
      {Language::python, {"", "kit = CLASS(ARGS)\n", "print(repr(CALL))\n", "", ""}},
      {Language::javascript, {"", "{ const kit = new CLASS(ARGS);\n", "  console.log(CALL);\n", "}\n", ""}},
      {Language::csharp,
       {"static class Check { static void Main() {\n", "{ var kit = new CLASS(ARGS);\n",
        "  System.Console.WriteLine(\"{0:R}\", CALL);\n", "}\n", "} }\n"}}};
  const auto put = [](std::string shape, const std::string& word, const std::string& by) {
    const std::size_t at = shape.find(word);
    return at == std::string::npos ? shape : shape.replace(at, word.size(), by);
  };
  const auto& [begin, make, print, end, finish] = shapes.at(language);
  text += begin;
  for (const auto& at : c.at) {
    std::vector<std::string> arguments;
    for (const Rational& r : made_from(c, at)) arguments.push_back(decimal_literal(r));
    text += put(put(make, "CLASS", class_name(c)), "ARGS", listed(arguments));
    for (const KitMember& a : kit_members(c, at)) text += put(print, "CALL", call(a, language));
    text += end;
  }
  return text + finish;
}

void compare_members(const LetteredKit& c, const std::string& output) {
  std::istringstream in(output);
  for (const auto& at : c.at)
    for (const KitMember& a : kit_members(c, at)) {
      CAPTURE(c.integrator);
      CAPTURE(a.member);
      std::string word;
      REQUIRE(bool(in >> word));
      const double found = std::stod(word), expected = a.expected.to_double();
      // Differences such as 1 - cos(w dt) lose what 1/(w dt)^2 has of digits.
      const double small =
          (std::abs(at[0].to_double()) + std::pow(at[1].to_double(), 2)) * std::pow(at[2].to_double(), 2);
      CHECK(std::abs(found - expected) <= 2e-15 * (4 + 40 / small) * (std::abs(expected) + 1e-2));
    }
}

/// param   run  with FILE for the file's name
void run_all(Language language, const std::string& file, const std::string& run) {
  for (const LetteredKit& c : lettered_kits()) {
    CAPTURE(c.integrator);
    const CodeFolder folder;
    folder.write(file, program(c, language));
    compare_members(c, folder.output(run));
  }
}

TEST_CASE("kits of springs, dampers and drag in C++ compile without a warning and give the certain digits" *
          doctest::test_suite("thorough")) {
  if (installed("g++"))
    run_all(Language::cpp, "kit.cpp",
            "g++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -o kit kit.cpp && ./kit");
}

TEST_CASE("kits of springs, dampers and drag in Python" * doctest::test_suite("thorough")) {
  if (installed("python3")) run_all(Language::python, "kit.py", "python3 kit.py");
}

TEST_CASE("kits of springs, dampers and drag in JavaScript" * doctest::test_suite("thorough")) {
  if (installed("node")) run_all(Language::javascript, "kit.js", "node kit.js");
}

TEST_CASE("kits of springs, dampers and drag in Rust" * doctest::test_suite("thorough")) {
  if (installed("rustc"))
    run_all(Language::rust, "kit.rs", "rustc --edition 2021 -D warnings -o kit kit.rs && ./kit");
}

TEST_CASE("kits of springs, dampers and drag in C#" * doctest::test_suite("thorough")) {
  if (installed("mcs") && installed("mono"))
    run_all(Language::csharp, "kit.cs", "mcs -out:kit.exe kit.cs && mono kit.exe");
}

TEST_CASE("in languages that are not run here blocks are closed and every member is declared") {
  for (const LetteredKit& c : lettered_kits())
    for (const Language language : {Language::csharp, Language::gdscript}) {
      const std::string text =
          linear_kit_code(kit_of(c, c.force, {}),
                          linear_derivation(find_integrator(c.integrator), force_named(c.force)), language);
      CHECK(std::ranges::count_if(text, [](char ch) { return ch == '('; }) ==
            std::ranges::count_if(text, [](char ch) { return ch == ')'; }));
      CHECK(std::ranges::count_if(text, [](char ch) { return ch == '{'; }) ==
            std::ranges::count_if(text, [](char ch) { return ch == '}'; }));
      CHECK(text.find("class " + class_name(c)) != std::string::npos);
      if (language == Language::gdscript) CHECK(text.find('{') == std::string::npos);
      if (language == Language::gdscript) CHECK(text.find(";\n") == std::string::npos);
    }
}

TEST_CASE("where a kit ends the class says that it has no number, and no kit is no code") {
  // rk4 can leave no less than 0.2704 of a velocity in one step.
  const LinearKit kit = linear_kit(find_integrator("rk4"), force_named("drag"));
  const std::string text =
      linear_kit_code(kit, linear_derivation(find_integrator("rk4"), force_named("drag")), Language::python);
  if (installed("python3")) {
    const CodeFolder folder;
    folder.write("kit.py", text +
                               "print(ExactDrag(5.0, 0.2).given_c == ExactDrag(5.0, 0.2).given_c)\n"
                               "print(ExactDrag(9.0, 0.2).given_c == ExactDrag(9.0, 0.2).given_c)\n");
    CHECK(folder.output("python3 kit.py") == "True\nFalse\n");
  }
}

}  // namespace
}  // namespace shortfall
