// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that nobody wrote, and some with names that are words of C++: written as classes, compiled and
// run.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/cpp_emitter.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "tests/program/random_program.hpp"
#include "tests/scratch_folder.hpp"

using namespace shortfall;

namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 3;

std::string hex(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%016llx",
                static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(value)));
  return value != value ? "nan" : text;
}

/// Everything carried, and what is reported, through some steps in binary64.
std::string interpreted(const Program& program) {
  Numbers<double> problem;
  problem.force = [](double x, double v, double t) { return (0.3 - x) + 0.1 * v + t; };
  const Tape tape = lower(program);
  Run<Numbers<double>> run(tape, problem, 0.02);
  std::string line;
  try {
    run.begin(0.7, -0.4, 0.5);
    for (int n = 0; n < kSteps; ++n) run.step();
    for (std::size_t s = 0; s < tape.states.size(); ++s) line += hex(run.state(static_cast<int>(s))) + " ";
    const auto [x, v] = run.read_out();
    return line + hex(x) + " " + hex(v);
  } catch (const Undefined&) {
    return "undefined";
  }
}

/// What the classes of some programs print, compiled by the compiler of this system: a line each.
std::vector<std::string> compiled(const std::vector<Program>& programs) {
  const ScratchFolder folder;
  const fs::path& path = folder.root();
  std::string calls;
  std::set<std::string> texts;
  std::ofstream main(path / "main.cpp");
  const std::regex number("number\\(\"([^\"]*)\"\\)");
  for (const Program& p : programs) {
    const CppClass c = cpp_class(p);
    std::ofstream(path / (p.name + ".hpp")) << c.text;
    main << "#include \"" << p.name << ".hpp\"\n";
    calls += "  show<" + c.name + ">();\n";
    for (std::sregex_iterator m(c.text.begin(), c.text.end(), number), end; m != end; ++m)
      texts.insert((*m)[1]);
  }
  main << R"(#include <bit>
#include <cstdio>
#include <string>
using namespace shortfall::native;
struct Force {
  double operator()(const double& x, const double& v, const double& t) const { return (0.3 - x) + 0.1 * v + t; }
};
double number_of(const std::string& text) {
)";
  for (const std::string& text : texts) {
    char value[40];
    std::snprintf(value, sizeof value, "%a", Rational::parse(text).to_double());
    main << "  if (text == \"" << text << "\") return " << value << ";\n";
  }
  main << R"(  return 0;
}
void print(double value) {
  if (value != value) std::printf("nan");
  else std::printf("%016llx", static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(value)));
}
template <template <class, class, class> class Class>
void show() try {
  const auto number = [](const char* text) { return number_of(text); };
  Class<double, double, Force> run(0.02, 0.0, Force{}, number, typename Class<double, double, Force>::Parameters(number));
  run.begin(0.7, -0.4, 0.5);
  run.run()"
       << kSteps << R"();
  for (const double value : run.carried()) print(value), std::printf(" ");
  const auto [x, v] = run.read_out();
  print(x), std::printf(" "), print(v), std::printf("\n");
} catch (const shortfall::Undefined&) {
  std::printf("undefined\n");
}
int main() {
)" << calls
       << "}\n";
  main.close();
  const std::string command = "cd '" + path.string() + "' && c++ -std=c++20 -O1 -ffp-contract=off -I'" +
                              SHORTFALL_SOURCE_DIR + "' main.cpp -o run && ./run > out";
  REQUIRE(std::system(command.c_str()) == 0);
  std::vector<std::string> lines;
  std::ifstream out(path / "out");
  for (std::string line; std::getline(out, line);) lines.push_back(line);
  return lines;
}

void check_same(const std::vector<Program>& programs) {
  if (std::system("c++ --version > /dev/null 2>&1") != 0) {
    MESSAGE("left out: no compiler is called c++ here");
    return;
  }
  const std::vector<std::string> lines = compiled(programs);
  REQUIRE(lines.size() == programs.size());
  for (std::size_t i = 0; i < programs.size(); ++i) {
    CAPTURE(print(programs[i]));
    CHECK(lines[i] == interpreted(programs[i]));
  }
}

std::string why_not(const std::string& text) {
  try {
    cpp_class(parse(text, "one.integrator"));
  } catch (const Unable& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("random programs, written as C++ and compiled, have the bits of the interpreter") {
  std::vector<Program> programs;
  int refused = 0, drawn = 0;
  CHECK(rc::check([&] {
    Program p = testing::RandomProgram().program();
    if (++drawn <= 50) return;  // the first ones are short and do nothing
    p.name = "random-" + std::to_string(programs.size());
    try {
      cpp_class(p);
      programs.push_back(parse(print(p), p.name + ".integrator"));
    } catch (const Unable& e) {
      // A scalar that changes only when v is fast.
      CHECK(std::string(e.what()).find("only when v is fast") != std::string::npos);
      ++refused;
    }
  }));
  CHECK(programs.size() + static_cast<std::size_t>(refused) == 50);
  CHECK(programs.size() > 25);
  const auto says_something = [](const Program& p) {
    const std::string line = interpreted(p);
    return line != "undefined" && line.find("nan") == std::string::npos;
  };
  CHECK(std::ranges::count_if(programs, says_something) > 15);
  check_same(programs);
}

TEST_CASE("names that are words of C++ or of the written class do not disturb it") {
  const std::string text = R"(integrator words
  source nobody
  param double = 0.3
  param N = 3
  param S : L/T = 0.2
  root V of V^2 = 2 near 1.4
  approx number = 0.1234567890123456789
  state steps_ : L
  state zero_ : L
  impulse time : L/T

start
  zero_ = x
  steps_ = x - h*v

step
  c0 = 2*h
  force_ = a(x, v + time, t + c0/2)
  substeps N {
    int = (double + V*number)*(h*v)
    c0 = h + c0
    solve guess : L/T^2 = a(x + h^2/4*guess, v, t) & held : L/T = v + h*guess
    zero_ = zero_ + int
  }
  v = v + h*force_ + 0*held
  limit speed S
  when speed > 0.1 {
    int = int*double
    v = 0.9*v + int/h*0
  }
  x = x + c0*v + int/3
  steps_ = x
finish
  x = x + 0*steps_
  v = (x - steps_)/h + v
)";
  check_same({parse(text, "words.integrator")});
}

TEST_CASE("what cannot be written is refused with its reason") {
  const std::string head = "integrator one\n  source nobody\n\nstep\n";
  CHECK(why_not(head + "  y = 1\n  when speed > 1 {\n    y = 2\n  }\n  x = x + y*h*v\n")
            .find("the scalar 'y'") != std::string::npos);
  CHECK(why_not(head + "  x = x + 2^40*h*v\n").find("only up to 32") != std::string::npos);
  CHECK(why_not(head + "  x = x + h*v\n") == "");
}
