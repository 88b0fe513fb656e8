// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <algorithm>

#include <bit>
#include <functional>
#include <map>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/program/random_program.hpp"

using namespace shortfall;
using shortfall::testing::RandomProgram;

namespace {

/// The bits of everything carried through three steps in binary32, under a force that depends on x, v and t.
std::vector<std::uint32_t> bits(const Program& program) {
  Numbers<float> problem;
  problem.force = [](float x, float v, float t) { return (0.3F - x) + 0.1F * v + t; };
  const Tape tape = lower(program);
  Run<Numbers<float>> run(tape, problem, 0.02F);
  std::vector<std::uint32_t> result;
  try {
    run.begin(0.7F, -0.4F, 0.5F);
    if (tape.impulse >= 0) run.give_impulse(0.25F);
    for (int n = 0; n < 3; ++n) {
      run.step();
      const auto [x, v] = run.read_out();
      for (const float value : {x, v}) result.push_back(std::bit_cast<std::uint32_t>(value));
    }
  } catch (const Undefined&) {  // a stage that cannot be solved
    result.push_back(0);
  }
  return result;
}

/// The texts without one pair of parentheses each, those left out that keep two signs apart.
std::vector<std::string> with_a_pair_less(const std::string& text) {
  std::vector<std::string> results;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') open.push_back(i);
    if (text[i] != ')') continue;
    const std::size_t begin = open.back();
    open.pop_back();
    if (text[begin + 1] == '-') continue;
    std::string less = text;
    less.erase(i, 1).erase(begin, 1);
    results.push_back(less);
  }
  return results;
}

Program with_value(const std::string& value) {
  return parse(
      "integrator one\n param p = 0.3\n param d : L = 1.25\n param q = p/2\nstep\n x = " + value + "\n",
      "one.integrator");
}

}  // namespace

TEST_CASE("every integrator of the catalogue is printed as a file that reads as the same integrator") {
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    const Program again = parse(print(program), "printed.integrator");
    CHECK(same(again, program));
    CHECK(print(again) == print(program));
    // The language has no substeps within substeps.
    if (std::ranges::find(program.step, Statement::Kind::substeps, &Statement::kind) != program.step.end())
      continue;
    const Program shorter = substepped(program, 3);
    CHECK(same(parse(print(shorter), "printed.integrator"), shorter));
  }
}

TEST_CASE("a random program is printed as a file that reads as the same program, rounding for rounding") {
  CHECK(rc::check([] {
    const Program program = RandomProgram().program();
    const Program again = parse(print(program), "printed.integrator");
    RC_ASSERT(same(again, program));
    RC_ASSERT(print(again) == print(program));
    RC_ASSERT(bits(again) == bits(program));
  }));
}

TEST_CASE("a random tableau is printed as a file that reads as the same tableau and the same step") {
  CHECK(rc::check([] {
    const Program program = RandomProgram().tableau_program();
    const Program once = parse(print(program), "once.integrator");
    const Program twice = parse(print(once), "twice.integrator");
    RC_ASSERT(same(once, twice));
    RC_ASSERT(bits(once) == bits(twice));
    Program without_step = once;
    without_step.step.clear();
    RC_ASSERT(same(without_step, program));
  }));
}

TEST_CASE("a random splitting is printed as a file that reads as the same splitting and the same step") {
  CHECK(rc::check([] {
    const Program program = RandomProgram().splitting_program();
    const Program once = parse(print(program), "once.integrator");
    const Program twice = parse(print(once), "twice.integrator");
    RC_ASSERT(same(once, twice));
    RC_ASSERT(bits(once) == bits(twice));
    Program without_step = once;
    without_step.step.clear();
    RC_ASSERT(same(without_step, program));
  }));
}

TEST_CASE("random programs make every statement of the language") {
  using Kind = Statement::Kind;
  std::map<Kind, int> seen;
  int impulses = 0, held = 0, functions = 0;
  const std::function<void(const std::vector<Statement>&)> count = [&](const std::vector<Statement>& block) {
    for (const Statement& s : block) {
      ++seen[s.kind];
      count(s.body);
    }
  };
  CHECK(rc::check([&] {
    for (int i = 0; i < 10; ++i) {  // a check of its own would begin with the same seed again
      const Program p = RandomProgram().program();
      count(p.step);
      impulses += p.impulse.has_value();
      held += p.holds_force;
      functions += print(p).find("max(") != std::string::npos;
    }
  }));
  for (const Kind kind :
       {Kind::assign, Kind::solve, Kind::substeps, Kind::limit_speed, Kind::limit_move, Kind::when})
    CHECK(seen[kind] >= 3);
  CHECK(impulses >= 3);
  CHECK(held >= 3);
  CHECK(functions >= 3);
  MESSAGE("of 1000 programs: " << seen[Kind::when] << " when, " << seen[Kind::limit_speed] << " and "
                               << seen[Kind::limit_move] << " limits, " << seen[Kind::substeps]
                               << " substeps, " << seen[Kind::solve] << " solve, " << impulses
                               << " impulses, " << held << " held forces, " << functions << " max");
}

TEST_CASE("no pair of parentheses that is printed could be left out") {
  CHECK(rc::check([] {
    const Program program = RandomProgram().program();
    const Expr value = program.step.back().value;
    const std::string text = print_decimals(value);
    for (const std::string& less : with_a_pair_less(text)) {
      try {
        RC_ASSERT_FALSE(same(with_value(less).step[0].value, value));
      } catch (const SyntaxError&) {
      }
    }
  }));
}

TEST_CASE("different programs are not the same") {
  const std::string text = "integrator one\nstep\n  x = x + h*v\n  v = v + h*a(x, v, t)\n";
  const Program one = parse(text, "one.integrator");
  CHECK(same(one,
             parse("integrator one\n\nstep\n x=x+(h*v) # drift\n v = v + h*a(x,\n v, t)", "two.integrator")));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"h*v", "v*h"},
                                                        {"one", "two"},
                                                        {"x + h*v", "h*v + x"},
                                                        {"h*v", "h/1*v"},
                                                        {"t)", "t + 0)"},
                                                        {"step\n", "  alias y\nstep\n"},
                                                        {"t)\n", "t)\nfinish\n v = v\n"},
                                                        {"step\n", "  param p = 1\nstep\n"}}) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    CAPTURE(other);
    CHECK_FALSE(same(one, parse(other, "other.integrator")));
  }
}

TEST_CASE("numbers of a program stay what they were") {
  for (const char* number : {"0.1", "2.5", "1e-3", "1e-400", "3e200", "0.30", "123456789.125", "1e-45", "7",
                             "1/3", "(1/3)", "-0.1"}) {
    CAPTURE(number);
    const Program program = with_value("x + " + std::string(number) + "*h*v");
    CHECK(same(parse(print(program), "printed.integrator"), program));
  }
  CHECK(print_decimals(number(Rational::parse("0.1"))) == "0.1");
  CHECK(print_decimals(number(Rational::parse("1e-400"))) == "1e-400");
  CHECK(print_decimals(number(Rational::parse("12e70"))) == "12e70");
  CHECK(print_decimals(number(0)) == "0");
  CHECK(print(number(Rational::parse("0.1"))) == "1/10");
}
