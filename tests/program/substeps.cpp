// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

using Exact = Numbers<Rational>;

/// A force that reads everything and is affine in x and v, so that implicit stages have rational solutions.
Exact problem() {
  Exact p;
  p.force = [](const Rational& x, const Rational& v, const Rational& t) {
    return Rational(3, 7) - Rational(2, 5) * x - Rational(1, 9) * v + Rational(5, 4) * t * t;
  };
  return p;
}

using Trajectory = std::vector<std::pair<Rational, Rational>>;

/// What is read out after every so many steps.
Trajectory trajectory(const Program& program, const Rational& h, int steps, int every,
                      const Values& given = {}) {
  Exact p = problem();
  const Tape tape = lower(program, given);
  Run<Exact> run(tape, p, h);
  run.begin(Rational(3, 8), Rational(-2, 3), Rational(1, 6));
  Trajectory result;
  for (int n = 1; n <= steps; ++n) {
    run.step();
    if (n % every == 0) result.push_back(run.read_out());
  }
  return result;
}

}  // namespace

TEST_CASE("a step with N substeps is N steps of h/N, for every integrator of the catalogue") {
  for (const Program& program : testing::undamped_catalogue())
    for (const int count : {1, 2, 5}) {
      // What is irrational cannot be stepped in rational numbers.
      const std::string text = print(program);
      if (!program.roots.empty() || text.substr(0, text.find("\nexpect")).find("sqrt(") != std::string::npos)
        continue;
      CAPTURE(program.name);
      CAPTURE(count);
      const Rational h(3, 10);
      CHECK(trajectory(substepped(program, count), h, 3, 1) ==
            trajectory(program, h / count, 3 * count, count));
    }
}

TEST_CASE("substeps written in the file do the same, and time runs on inside them") {
  const std::string body = "v = v + h*a(x, v, t)\n x = x + h*v\n";
  const Program plain = parse("integrator plain\nstep\n" + body, "plain.integrator");
  const Program four = parse("integrator four\nstep\n substeps 4 {\n" + body + "}\n", "four.integrator");
  CHECK(trajectory(four, Rational(1, 2), 3, 1) == trajectory(plain, Rational(1, 8), 12, 4));
}

TEST_CASE("after the substeps t is the step's beginning and h the whole step again") {
  const Program program = parse(
      "integrator both\nstep\n substeps 3 {\n x = x + h*v\n }\n v = v + h*a(x, v, t)\n", "both.integrator");
  const Program written_out =
      parse("integrator out\nstep\n x = x + h/3*v\n x = x + h/3*v\n x = x + h/3*v\n v = v + h*a(x, v, t)\n",
            "out.integrator");
  CHECK(trajectory(program, Rational(1, 2), 3, 1) == trajectory(written_out, Rational(1, 2), 3, 1));
}

TEST_CASE("the number of substeps may be a parameter, and its default may follow from another") {
  const std::string body = "v = v + h*a(x, v, t)\n x = x + h*v\n";
  const Program plain = parse("integrator plain\nstep\n" + body, "plain.integrator");
  const Program program = parse(
      "integrator many\n param half = 1\n param count = 2*half\nstep\n substeps count {\n" + body + "}\n",
      "many.integrator");
  const Rational h(1, 2);
  CHECK(trajectory(program, h, 2, 1) == trajectory(plain, h / 2, 4, 2));
  CHECK(trajectory(program, h, 2, 1, {{"half", 3}}) == trajectory(plain, h / 6, 12, 6));
  CHECK(trajectory(program, h, 2, 1, {{"count", 5}}) == trajectory(plain, h / 5, 10, 5));
}

TEST_CASE("a number of substeps that is none is refused") {
  const Program program = parse(
      "integrator many\n param count = 2\nstep\n substeps count {\n x = x + h*v\n }\n", "many.integrator");
  for (const char* count : {"0", "-1", "1/2", "10001", "1e30"}) {
    CAPTURE(count);
    CHECK_THROWS_AS(lower(program, {{"count", Rational::parse(count)}}), BadInput);
  }
  CHECK_THROWS_WITH_AS(substepped(program, 0),
                       "a number of substeps is a whole number from 1 to 10000, not 0", BadInput);
  CHECK_THROWS_AS(substepped(program, 10001), BadInput);
}
