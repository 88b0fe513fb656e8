// SPDX-License-Identifier: GPL-3.0-or-later
// Roots, splittings, functions, impulses, limits and held forces: read, printed and run.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/program/written_program.hpp"

using namespace shortfall;
using testing::after, testing::read, testing::with_step;

namespace {

/// What a user reads; "" when the file is accepted.
std::string first_complaint(const std::string& head, const std::string& blocks = "step\n  x = x + h*v") {
  try {
    read(head, blocks);
    return "";
  } catch (const SyntaxError& e) {
    const std::string what = e.what();
    return what.substr(0, what.find('\n'));
  }
}

/// At which step a limit first acted, or a `when` did not hold; 0 when never.
std::int64_t first_deviation(const Program& program, int steps, double x, double v) {
  const Tape tape = lower(program);
  Numbers<double> problem{[](double, double, double) { return -10.0; }};
  Run<Numbers<double>> run(tape, problem, 0.1);
  run.begin(x, v, 0.0);
  for (int n = 0; n < steps; ++n) run.step();
  return run.deviation() ? run.deviation()->step : 0;
}

}  // namespace

TEST_CASE("everything of the second half prints as a file that reads as the same program") {
  const Program p = parse(R"(# An engine.
integrator everything
  alias  Every Thing
  source somebody
  param  c : 1/T = 0.1
  param  N = 4
  root   theta of 6*theta^3 - 12*theta^2 + 6*theta = 1
  root   r of r^2 = 2*r + 1 near -0.4
  approx w1 = -1.1776799841788710
  state  f : L/T^2
  impulse j : L/T
  hold   a
  assume 1 - c*h > 0
  assume c*h < 1
  solves a(x, v, t) - c*v

start
  f = a(x, v, t)

step
  substeps N {
    when speed > 0.01 {
      v = (v + j/N + theta*r*w1*h*a(x, v, t))*max(0, 1 - c*h)
    }
    limit speed 500
  }
  f = a(x, v, t)*pow(1/2, h)*exp(-c*h)*sqrt(2)*min(c*h, 1)
  limit move 2
  x = x + h*v

expect
  trace 2 - h^2*w^2
  determinant 1
  limit 2*sqrt(2)
)",
                          "everything.integrator");
  const std::string text = print(p);
  const Program again = parse(text, "again.integrator");
  CHECK(same(p, again));
  CHECK(print(again) == text);
  CHECK(p.roots[1].value->significant(6) == "-0.414214");
  CHECK(p.approximations[0].text == "-1.1776799841788710");
}

TEST_CASE("a splitting is the statements that a person would write, time advancing with the drifts") {
  const Program splitting = read("", "splitting\n  kick 1/3\n  drift 2/3\n  kick 2/3\n  drift 1/3");
  const Program written = with_step(
      "  v = v + 1/3*h*a(x, v, t)\n  x = x + 2/3*h*v\n  v = v + 2/3*h*a(x, v, t + 2/3*h)\n  x = x + 1/3*h*v");
  CHECK(after<Rational>(splitting, 7, Rational(1, 10)) == after<Rational>(written, 7, Rational(1, 10)));
  CHECK(print(parse(print(splitting), "again")) == print(splitting));
}

TEST_CASE("an irrational coefficient is rounded once, and has no value in rational numbers") {
  const Program p = with_step("  v = v + r*h*a(x, v, t)\n  x = x + h*v", "  root r of r^2 = 2 near 1");
  const Program q =
      with_step("  v = v + 1.41421356237309504880168872420969807856967*h*a(x, v, t)\n  x = x + h*v");
  CHECK(after<double>(p, 5, 0.1) == after<double>(q, 5, 0.1));
  CHECK(after<float>(p, 5, 0.1F) == after<float>(q, 5, 0.1F));
  CHECK_THROWS_AS(after<Rational>(p, 1, Rational(1, 10)), Unable);
  // In Q(sqrt(2)) it has: one step from x = 1, v = 2 with a = -2 gives v = 2 - sqrt(2)/5.
  CHECK(after<Surd>(p, 1, Surd(Rational(1, 10))).second == Surd(2, Rational(-1, 5), 2));
  CHECK_THROWS_AS(after<Rational>(with_step("  x = x + sqrt(2)*h*v"), 1, Rational(1)), Unable);
  CHECK(after<Rational>(with_step("  x = x + sqrt(4/9)*h*v"), 1, Rational(1)).first == Rational(7, 3));
}

TEST_CASE("functions are those of the C library, and exact where they can be") {
  // exp takes a number without dimension.
  CHECK(first_complaint("  param c : 1 = 0.3", "step\n  v = v*exp(-c*h)\n  x = x + h*v") ==
        "test.integrator:4:13: exp takes a number without dimension; found scalar [T]");
  const Program q = with_step("  v = v*pow(1 - c, h)*exp(-c*d*h)\n  x = x + max(h, 0*h)*v",
                              "  param c = 0.3\n  param d : 1/T = 2");
  const double v = 2.0 * std::pow(1.0 - 0.3, 0.1) * std::exp(-0.3 * 2.0 * 0.1);
  CHECK(after<double>(q, 1, 0.1).second == v);
  CHECK(after<double>(q, 1, 0.1).first == 1.0 + 0.1 * v);
  CHECK(after<Rational>(q, 1, Rational(1, 10), {{"c", 0}}).second == Rational(2));
  CHECK(after<Rational>(q, 1, Rational(2), {{"c", Rational(1, 2)}, {"d", 0}}).second == Rational(1, 2));
  CHECK_THROWS_AS(after<Rational>(q, 1, Rational(1, 10)), Unable);
}

TEST_CASE("an impulse acts in the first step only, also when that is taken in substeps") {
  const Program p = with_step("  v = v + j + h*a(x, v, t)\n  x = x + h*v", "  impulse j : L/T");
  const Program q = with_step("  v = v + h*a(x, v, t)\n  x = x + h*v");
  const Rational h(1, 10);
  CHECK(after<Rational>(p, 3, h) == after<Rational>(q, 3, h));
  // By hand: v = 2 + 5 - 1/10*2 = 34/5, x = 1 + 34/50.
  CHECK(after<Rational>(p, 1, h, {}, 5) == std::pair(Rational(42, 25), Rational(34, 5)));
  CHECK(after<Rational>(substepped(p, 4), 1, h, {}, 5) == after<Rational>(p, 4, h / Rational(4), {}, 5));
  CHECK(after<Rational>(undisturbed(p), 3, h) == after<Rational>(q, 3, h));
  const Tape tape = lower(q);
  Numbers<Rational> problem{[](const Rational&, const Rational&, const Rational&) { return Rational(0); }};
  Run<Numbers<Rational>> run(tape, problem, h);
  CHECK_THROWS_AS(run.give_impulse(1), BadInput);
}

TEST_CASE("a held force is evaluated once a frame") {
  const std::string step = "  substeps 3 {\n    v = v + h*a(x, v, t)\n    x = x + h*v\n  }";
  const Program held = with_step(step, "  hold a");
  const Program by_hand =
      with_step("  f = a(x, v, t)\n  substeps 3 {\n    v = v + h*f\n    x = x + h*v\n  }");
  const Rational h(3, 10);
  CHECK(after<Rational>(held, 5, h) == after<Rational>(by_hand, 5, h));
  CHECK(after<Rational>(held, 5, h) != after<Rational>(with_step(step), 5, h));
  CHECK(after<Rational>(undisturbed(held), 5, h) == after<Rational>(held, 5, h));
  const Program once = with_step("  v = v + h*a(x, v, t)\n  x = x + h*v", "  hold a");
  CHECK(after<Rational>(substepped(once, 3), 5, h) == after<Rational>(held, 5, h));
}

TEST_CASE("limits act where they stand, and a run tells when they first did") {
  const Program speed = with_step("  v = v + h*a(x, v, t)\n  limit speed 3\n  x = x + h*v");
  // Under -10 from rest with h = 0.1: -1, -2, -3, then -4 is limited to -3, in step 4.
  CHECK(first_deviation(speed, 3, 0, 0) == 0);
  CHECK(first_deviation(speed, 10, 0, 0) == 4);
  const Program move = with_step("  v = v + h*a(x, v, t)\n  limit move 1/4\n  x = x + h*v");
  CHECK(first_deviation(move, 10, 0, 0) == 3);
  const Program when =
      with_step("  v = v + h*a(x, v, t)\n  when speed > 3/2 {\n    v = v/2\n  }\n  x = x + h*v");
  CHECK(first_deviation(when, 10, 0, 0) == 1);
  CHECK(first_deviation(when, 1, 0, 10) == 0);
  CHECK(same(undisturbed(speed), with_step("  v = v + h*a(x, v, t)\n  x = x + h*v")));
  CHECK(same(undisturbed(when), with_step("  v = v + h*a(x, v, t)\n  v = v/2\n  x = x + h*v")));
}

TEST_CASE("mistakes in the second half are pointed at") {
  CHECK(first_complaint("  root r of r^2 = -1") ==
        "test.integrator:2:8: the equation of the root 'r' has no real solution");
  CHECK(first_complaint("  root r of r^2 = 2")
            .starts_with("test.integrator:2:8: the equation of the root 'r' has 2 real solutions, -1.4142, "
                         "1.4142; say which with: near"));
  CHECK(first_complaint("  root r of r^13 = 2").find("a whole number from 0 to 12") != std::string::npos);
  CHECK(first_complaint("  root r of q^2 = 2 near 1").find("is made of numbers and 'r'; found 'q'") !=
        std::string::npos);
  CHECK(first_complaint("  root h of h^3 = 2").find("'h' has a meaning of its own") != std::string::npos);
  CHECK(first_complaint("  approx w = 2").find("the number is exact") != std::string::npos);
  CHECK(first_complaint("  impulse j : L").find("is a velocity, L/T, not L") != std::string::npos);
  CHECK(first_complaint("  impulse j : L/T\n  impulse k : L/T").find("there is already an impulse, 'j'") !=
        std::string::npos);
  CHECK(first_complaint("  hold x").find("hold a") != std::string::npos);
  CHECK(first_complaint("  assume h").find("an assumption compares two values") != std::string::npos);
  CHECK(first_complaint("  assume h > 1").find("compares like with like") != std::string::npos);
  CHECK(first_complaint("  solves x").find("the equation is a vector [L T^-2], found a vector [L]") !=
        std::string::npos);
  CHECK(first_complaint("", "step\n  limit speed -1\n  x = x + h*v").find("a speed above 0") !=
        std::string::npos);
  CHECK(first_complaint("", "step\n  limit spin 1\n  x = x + h*v").find("the speed or the move") !=
        std::string::npos);
  CHECK(first_complaint("", "step\n  when speed > 1 {\n    q = v\n  }\n  x = x + h*q")
            .find("within when only") != std::string::npos);
  CHECK(first_complaint("", "step\n  when speed > 1 {\n  x = x + h*v").find("this when { is never closed") !=
        std::string::npos);
  CHECK(first_complaint("", "splitting\n  push 1").find("a splitting holds rows such as") !=
        std::string::npos);
  CHECK(first_complaint("", "splitting\n  kick h").find("a weight is made of numbers") != std::string::npos);
  CHECK(first_complaint("", "splitting\n").find("has no rows") != std::string::npos);
  CHECK(first_complaint("", "splitting\n  drift 1\nstep\n  x = x + h*v")
            .find("a step or a splitting, not both") != std::string::npos);
  CHECK(first_complaint("  impulse j : L/T", "start\n  v = v + j\nstep\n  x = x + h*v")
            .find("acts in the step block only") != std::string::npos);
  CHECK(first_complaint("", "step\n  x = x + h*v\nexpect\n  limit 2*h").find("a limit is a number") !=
        std::string::npos);
  CHECK(first_complaint("", "step\n  x = x + h*v*log(2)").find("there are sqrt, exp, pow, max, min") !=
        std::string::npos);
}
