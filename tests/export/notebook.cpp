// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/notebook.hpp"
#include "notebooks-export/figure_gnuplot.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/export/python_run.hpp"

namespace shortfall {
namespace {

/// Runs notebooks as tests/export/run_notebook.py says.
ShellRun run_notebooks(const std::string& python, const std::string& files) {
  return shell_run("'" + python + "' '" SHORTFALL_SOURCE_DIR "/tests/export/run_notebook.py' " + files);
}

std::string exported(const Program& program, int degree, const Values& given = {}, int substeps = 1) {
  const Derivation d = derivation(program, degree, given, substeps);
  CHECK(d.proved());
  return notebook(program, given, d, correction_kit(d));
}

std::string exported(const std::string& name, int degree, const Values& given = {}, int substeps = 1) {
  return exported(find_integrator(name), degree, given, substeps);
}

std::string altered(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// What is awkward to write in Python: its words as names, whole numbers, substeps, a stage
/// of several unknowns, a start that takes a while to be forgotten.
constexpr const char* kAwkward = R"(# A_B *c* $x$ `d` <e> [f]
integrator awkward
  source Nobody & <b>Nobody</b> (1999), On $n$
  param  lambda = 2
  param  class = 1/lambda
  param  many = 2
  param  n2 : 1/T = 0
  state  print : L/T^2
  state  y : L

start
  print = 0
  y = 0*x

step
  for = 3/4 - 2^-1
  def = h/2*a(x, v, t) + 0*print
  substeps many {
    solve in : L/T^2 = a(x + h^2*is*0, v, t + h) & is : L/T^2 = in/lambda + class*a(x, v, t)*0
    v = v + h/2*in + for*h*lambda*in*class + h*(in - is*lambda)
    x = x + h*v/1 + 0*def*h
  }
  x = x + n2*h*(y - y)
  y = x
  print = a(x, v, t + h)
)";

TEST_CASE("every notebook's cells run and their assertions hold" * doctest::test_suite("thorough")) {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: notebooks are written, but not run");
  }
  const ScratchFolder folder;
  const auto add = [&](const std::string& name, const std::string& text) {
    folder.write(name + ".ipynb", text);
  };
  for (const Program& program : catalogue()) {
    // The formulas of engines divide by their damping, which notebooks would set to its default, 0.
    if (family(program) == "engines") continue;
    if (program.approximate() || !step_map(lower(program), -1).generators.empty()) {  // no exact fractions
      CHECK_THROWS_AS(exported(program, 0), Unable);
      continue;
    }
    for (const int degree : {0, 2})
      add(program.name + "-" + std::to_string(degree), exported(program, degree));
  }
  add("newmark-given", exported("newmark", 1, {{"beta", Rational(1, 6)}}));
  add("newmark-all-given", exported("newmark", 2, {{"beta", Rational(1, 6)}, {"gamma", Rational(3, 5)}}));
  add("generalised-alpha-given", exported("generalised-alpha", 1, {{"rho", Rational(1, 2)}}));
  add("substeps-constant", exported("symplectic-euler", 0, {}, 4));
  add("substeps-cubic", exported("symplectic-euler", 3, {}, 4));
  add("substeps-start-and-finish", exported("leapfrog", 1, {}, 4));
  add("substeps-multistep", exported("beeman", 2, {}, 3));
  add("awkward", exported(parse(kAwkward, "awkward.integrator"), 1));
  if (interpreter.empty()) return;
  const ShellRun outcome = run_notebooks(interpreter, "'" + folder.root().string() + "'/*.ipynb");
  INFO(outcome.output);
  CHECK(outcome.code == 0);
}

TEST_CASE("a notebook fails when one coefficient of its formulas is wrong") {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: not run");
    return;
  }
  const std::string right = exported("symplectic-euler", 0);
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"v = v + h * a(x, v, t)", "v = v + h / 2 * a(x, v, t)"},  // the step
      {"x0 + v0 * t + Fraction(1, 2) * a * t**2\\n",
       "x0 + v0 * t + Fraction(1, 3) * a * t**2\\n"},  // the true motion
      {"assert x[n] == x0 + v0 * t + Fraction(1, 2)",
       "assert x[n] == x0 + v0 * t + Fraction(1, 4)"},  // a line
      {"\\\"\\\"\\\"x_n in closed form.\\\"\\\"\\\"\\n\",\n    \"    t = n * h\\n\",\n    \"    return x0",
       "\\\"\\\"\\\"x_n in closed form.\\\"\\\"\\\"\\n\",\n    \"    t = n * h\\n\",\n    \"    return 2 * "
       "x0"},
      {"return -Fraction(1, 2) * a * h * t", "return -Fraction(1, 3) * a * h * t"},  // the shortfall
      {"v = v0 - Fraction(1, 2) * a * h", "v = v0 + Fraction(1, 2) * a * h"},        // a correction
      {"assert impossible([\\\"force\\\"])", "assert impossible([\\\"launch v\\\", \\\"read v\\\"])"},
      {"\\\"2.762010199\\\"", "\\\"2.762010198\\\""}};  // the jump
  const ScratchFolder folder;
  folder.write("right.ipynb", right);
  CHECK(run_notebooks(interpreter, quoted(folder, "right.ipynb")).code == 0);
  int number = 0;
  std::string files;
  for (const auto& [from, to] : mistakes) {
    const std::string name = "wrong" + std::to_string(number++) + ".ipynb";
    folder.write(name, altered(right, from, to));
    files += " " + quoted(folder, name);
  }
  const ShellRun outcome = run_notebooks(interpreter, files);
  INFO(outcome.output);
  CHECK(outcome.code == 1);
  CHECK(outcome.output.find("\n0 notebooks passed, " + std::to_string(mistakes.size()) + " failed") !=
        std::string::npos);
}

TEST_CASE("a notebook is also one for Jupyter" * doctest::test_suite("thorough")) {
  const std::string interpreter = python();
  if (interpreter.empty()) {
    MESSAGE("python3 is not installed: not run");
    return;
  }
  const ScratchFolder folder;
  folder.write("falling-short.ipynb", exported("symplectic-euler", 0));
  const ShellRun outcome = run_notebooks(interpreter, "--jupyter " + quoted(folder, "falling-short.ipynb"));
  INFO(outcome.output);
  if (outcome.code == 77)
    MESSAGE("nbformat, nbconvert and ipykernel are not installed: not run in Jupyter");
  else
    CHECK(outcome.code == 0);
}

TEST_CASE("the same question gives the same notebook, byte for byte") {
  CHECK(exported("newmark", 2) == exported("newmark", 2));
  CHECK(exported("newmark", 2) != exported("newmark", 1));
}

TEST_CASE("a picture that is given stands below its cell, under a constant force only") {
  const auto pictures = [](int degree) {
    const Program program = find_integrator("symplectic-euler");
    const Derivation d = derivation(program, degree);
    const auto file = nlohmann::json::parse(notebook(program, {}, d, correction_kit(d), "\x89PNG"));
    int count = 0;
    for (const auto& cell : file["cells"])
      if (cell.contains("outputs"))
        for (const auto& output : cell["outputs"]) count += output["data"]["image/png"] == "iVBORw==";
    return count;
  };
  CHECK(pictures(0) == 1);
  CHECK(pictures(1) == 0);
}

TEST_CASE("text of a user's file is shown as it stands, and is no markup") {
  const auto file = nlohmann::json::parse(exported(parse(kAwkward, "awkward.integrator"), 0));
  std::string text;
  for (const auto& line : file["cells"][1]["source"]) text += line.get<std::string>();
  CHECK(text.find("A\\_B \\*c\\* \\$x\\$ \\`d\\` \\<e\\> \\[f\\].") != std::string::npos);
  CHECK(text.find("<b>") == std::string::npos);
}

TEST_CASE("a notebook of a degree that nobody reads is refused" * doctest::test_suite("thorough")) {
  const Program& program = catalogue().front();
  const Derivation d = derivation(program, 31, {}, 1, false);
  CHECK_THROWS_WITH_AS(notebook(program, {}, d, {}),
                       "a notebook is written for forces of degree up to 30, not 31", Unable);
}

TEST_CASE("shortfall export writes the notebook, and replaces an older one") {
  const ScratchFolder folder;
  const std::string file = (folder.root() / "falling-short.ipynb").string();
  folder.write("falling-short.ipynb", "an older one");
  const std::string command = "'" SHORTFALL_BINARY "' export symplectic-euler --force constant";
  const ShellRun outcome = shell_run(command + " --notebook -o '" + file + "'");
  CHECK(outcome.code == 0);
  const bool draws = gnuplot_is_here();
  CHECK(outcome.output.empty());
  std::ostringstream written;
  written << std::ifstream(file, std::ios::binary).rdbuf();
  auto json = nlohmann::ordered_json::parse(written.str());
  int pictures = 0;
  for (auto& cell : json["cells"])
    if (cell.contains("outputs") && !cell["outputs"].empty()) {
      ++pictures;
      CHECK(cell["outputs"][0]["data"]["image/png"].get<std::string>().starts_with("iVBORw0KGgo"));
      cell["outputs"] = nlohmann::ordered_json::array();
    }
  CHECK(pictures == draws);
  CHECK(json.dump(1) + "\n" == exported("symplectic-euler", 0));
  CHECK(shell_run("{ " + command + " --notebook 2>/dev/null; }").output == written.str());
  CHECK(shell_run(command).code == 2);
  CHECK(shell_run(command + " --notebook --latex").code == 2);
  CHECK(shell_run(command + " --notebook -o /nowhere/at/all.ipynb").code == 5);
  CHECK(shell_run(command + " --latex").output.find("\\[ x(t) - x_{n}") != std::string::npos);
  CHECK(shell_run("'" SHORTFALL_BINARY "' export symplectic-euler --force poly:31 --notebook").code == 4);
}

}  // namespace
}  // namespace shortfall
