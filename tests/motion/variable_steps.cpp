// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of any lengths under a constant acceleration. Truth is plain stepping with rational numbers, written
// out here for the methods known by hand, by the interpreter for the others.
#include "analysis/motion/variable_steps.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/undamped_catalogue.hpp"

namespace shortfall {
namespace {

using Steps = std::vector<Rational>;

Steps random_steps() {
  Steps steps;
  for (int k = *rc::gen::inRange(1, 12); k > 0; --k)
    steps.push_back(Rational(*rc::gen::inRange(1, 40), *rc::gen::inRange(40, 200)));
  return steps;
}

Rational random_number() { return Rational(*rc::gen::inRange(-50, 50), *rc::gen::inRange(1, 20)); }

/// Positions and velocities that are reported after each step.
std::vector<std::pair<Rational, Rational>> stepped(const Program& program, const Steps& steps,
                                                   const Rational& x0, const Rational& v0, const Rational& a,
                                                   const Values& given = {}) {
  const Tape tape = lower(program, given);
  Numbers<Rational> problem{.force = [&](const Rational&, const Rational&, const Rational&) { return a; }};
  Run<Numbers<Rational>> run(tape, problem, steps.front());
  run.begin(x0, v0, 0);
  std::vector<std::pair<Rational, Rational>> result;
  for (const Rational& h : steps) {
    run.set_step(h);
    run.step();
    result.push_back(run.read_out());
  }
  return result;
}

Rational value(const Fraction& f) { return f.evaluate({}); }

/// The law as its docstring states it.
std::pair<Rational, Rational> by_law(const VariableStepLaw& l, const Steps& steps, const Rational& x0,
                                     const Rational& v0, const Rational& a) {
  Rational t, squares;
  for (const Rational& h : steps) {
    t += h;
    squares += h * h;
  }
  const Rational &first = steps.front(), &last = steps.back();
  const Rational both = value(l.drift) * value(l.kick) / 2;
  return {
      x0 + value(l.start_position) * a * first * first +
          value(l.drift) * (v0 + value(l.start_velocity) * a * first) * t + both * a * t * t +
          (value(l.alpha) - both) * a * squares + value(l.read_position) * a * last * last,
      v0 + value(l.start_velocity) * a * first + value(l.kick) * a * t + value(l.read_velocity) * a * last};
}

Program written(const std::string& head, const std::string& step) {
  return parse("integrator test\n" + head + "\nstep\n" + step + "\n", "test.integrator");
}

TEST_CASE("kick-drift symplectic Euler falls short by -a/2 times the sum of the squares of its steps") {
  const VariableSteps steps = variable_steps(find_integrator("symplectic-euler"));
  REQUIRE(steps.law);
  CHECK(steps.law->alpha.is_one());
  CHECK(print(shortfall_formula(*steps.law)) == "-1/2*a*sum(k, 1, n, h_k^2)");
  CHECK(print(position_change(*steps.law)) == "h*v + a*h^2");
  CHECK(print(square_term(*steps.law)) == "-1/2*a*h^2");
  CHECK(rc::check([] {
    const Rational a = random_number(), x0 = random_number(), v0 = random_number();
    const Steps list = random_steps();
    Rational x = x0, v = v0, t, squares;
    for (const Rational& h : list) {  // the method by hand
      v += a * h;
      x += h * v;
      t += h;
      squares += h * h;
    }
    RC_ASSERT(x0 + v0 * t + a * t * t / 2 - x == -a / 2 * squares);
    RC_ASSERT(stepped(find_integrator("symplectic-euler"), list, x0, v0, a).back() == std::make_pair(x, v));
  }));
}

TEST_CASE("alpha is read off the step") {
  const std::map<std::string, Rational> alphas{{"explicit-euler", 0},
                                               {"symplectic-euler", 1},
                                               {"symplectic-euler-drift-kick", 0},
                                               {"implicit-euler", 1},
                                               {"velocity-verlet", Rational(1, 2)},
                                               {"position-verlet", Rational(1, 2)},
                                               {"rk4", Rational(1, 2)},
                                               {"beeman", Rational(1, 2)},
                                               {"newmark", Rational(1, 2)},
                                               {"leapfrog", 1}};
  for (const auto& [word, alpha] : alphas) {
    const std::string name = word;
    CAPTURE(name);
    const VariableSteps steps = variable_steps(find_integrator(name));
    REQUIRE(steps.law);
    CHECK(steps.law->alpha == Fraction(alpha));
  }
  // N substeps: the mean of what is missing and of nothing missing.
  for (int n : {2, 4, 7})
    CHECK(variable_steps(substepped(find_integrator("symplectic-euler"), n)).law->alpha ==
          Fraction(Rational(1, 2) + Rational(1, 2 * n)));
}

TEST_CASE("alpha is a formula in the parameters of an integrator") {
  const Program theta = written("  param theta = 1/4",
                                "  w = v\n  v = v + h*a(x, v, t)\n  x = x + h*((1 - theta)*w + theta*v)");
  const VariableSteps steps = variable_steps(theta);
  REQUIRE(steps.law);
  CHECK(steps.law->alpha.str(steps.law->letters) == "theta");
  CHECK(print(shortfall_formula(*steps.law)).find("theta") != std::string::npos);
  CHECK(list_exactness(theta).exact == false);
  CHECK(list_exactness(theta, {{"theta", Rational(1, 2)}}).exact == true);
}

TEST_CASE("what leapfrog's half kick at the start was made for is the first step alone") {
  const VariableSteps steps = variable_steps(find_integrator("leapfrog"));
  REQUIRE(steps.law);
  CHECK(print(shortfall_formula(*steps.law)) == "-1/2*a*sum(k, 1, n, h_k^2) + 1/2*a*h_1*t");
  CHECK_FALSE(steps.law->only_squares());
}

TEST_CASE("what start or finish add counts too: alpha = 1/2 alone is not exact") {
  const std::string step = "step\n  x = x + h*v + h^2/2*a(x, v, t)\n  v = v + h*a(x, v, t)\n";
  const auto exact = [&](const std::string& before, const std::string& after) {
    return list_exactness(parse("integrator test\n" + before + step + after, "t")).exact;
  };
  CHECK(exact("", "") == true);
  CHECK(exact("start\n  v = v + h*a(x, v, t)\n", "") == false);
  CHECK(exact("start\n  x = x + h^2*a(x, v, t)\n", "") == false);
  CHECK(exact("", "finish\n  x = x + h^2*a(x, v, t)\n") == false);
  CHECK(exact("", "finish\n  v = v + h*a(x, v, t)\n") == true);  // positions are
}

namespace {

/// Whether it can be stepped in rational numbers.
bool rational(const Program& program) { return step_map(lower(program), 0).extras.empty(); }

}  // namespace

TEST_CASE(
    "integrators with irrational coefficients have a law too; with decimals that stand for others nothing is "
    "said") {
  for (const char* exact : {"forest-ruth", "suzuki4", "mclachlan-atela-3", "gauss4", "sdirk2"})
    CHECK(list_exactness(find_integrator(exact)).exact == true);
  CHECK_FALSE(list_exactness(find_integrator("pefrl")).exact.has_value());
}

TEST_CASE("the law is what stepping does, for the whole catalogue and random lists") {
  CHECK(rc::check([] {
    const Program program =
        substepped(*rc::gen::elementOf(testing::undamped_catalogue()), *rc::gen::element(1, 1, 3));
    const VariableSteps steps = variable_steps(program, parameter_values(program));
    if (!steps.law) {
      RC_ASSERT(!steps.reason.empty());
      return;
    }
    if (!rational(program)) return;
    RC_LOG() << program.name << "\n";
    const Rational a = random_number(), x0 = random_number(), v0 = random_number();
    const Steps list = random_steps();
    RC_ASSERT(stepped(program, list, x0, v0, a).back() == by_law(*steps.law, list, x0, v0, a));
  }));
}

TEST_CASE("the law is what stepping does for random steps of its form, start and finish included") {
  CHECK(rc::check([] {
    const auto number = [] { return "(" + random_number().str() + ")"; };
    const Program program =
        parse("integrator test\nstart\n  x = x + " + number() + "*h^2*a(x, v, t)\n  v = v + " + number() +
                  "*h*a(x, v, t)\nstep\n  x = x + " + number() + "*h*v + " + number() +
                  "*h^2*a(x, v, t)\n  v = v + " + number() + "*h*a(x, v, t)\nfinish\n  x = x + " + number() +
                  "*h^2*a(x, v, t)\n  v = v + " + number() + "*h*a(x, v, t)\n",
              "test.integrator");
    const VariableSteps steps = variable_steps(program);
    RC_ASSERT(steps.law.has_value());
    const Rational a = random_number(), x0 = random_number(), v0 = random_number();
    const Steps list = random_steps();
    RC_ASSERT(stepped(program, list, x0, v0, a).back() == by_law(*steps.law, list, x0, v0, a));
  }));
}

TEST_CASE("methods that use what an earlier step has left behind have no law, and say what it is") {
  for (const auto& [word, state] :
       std::map<std::string, std::string>{{"adams-bashforth-2", "v_prev"},
                                          {"stoermer-verlet", "x_prev"},
                                          {"stoermer-verlet-wrong-start", "x_prev"}}) {
    const std::string name = word;
    CAPTURE(name);
    const VariableSteps steps = variable_steps(find_integrator(name));
    CHECK_FALSE(steps.law);
    CHECK(steps.reason == "the position depends on " + state +
                              ", which an earlier step has left behind, of a length of its own");
    CHECK(list_exactness(find_integrator(name)).exact == false);
  }
}

TEST_CASE("other steps say in what they differ") {
  const auto reason = [](const std::string& head, const std::string& step) {
    return variable_steps(written(head, step)).reason;
  };
  CHECK(reason("  param c : 1/T = 1/10", "  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v")
            .find("no multiple of h") != std::string::npos);
  CHECK(reason("  param c : 1/T = 1/10", "  x = x + h*v\n  v = v*(1 - c*h)") ==
        "the velocity is multiplied by -h*c + 1, not by 1");
  CHECK(reason("  param k : 1/T^2 = 1", "  v = v + h*a(x, v, t) - h*k*x\n  x = x + h*v")
            .find("the position is multiplied by") != std::string::npos);
}

TEST_CASE("unrolled in letters, Adams-Bashforth misses what unequal neighbours differ in") {
  const std::vector<Expr> missing = unrolled_shortfalls(find_integrator("adams-bashforth-2"), 3);
  REQUIRE(missing.size() == 3);
  CHECK(is_number(missing[0], 0));
  CHECK(print(missing[1]) == "-1/2*h_1*h_2*a + 1/2*h_2^2*a");
  // By hand: x += h/2 (3 v - w), w the velocity one step before, so that frame k >= 2 misses a h_k (h_k -
  // h_(k-1))/2.
  CHECK(rc::check([] {
    const Steps list = random_steps();
    Rational expected, t;
    for (std::size_t k = 0; k < list.size(); ++k) {
      t += list[k];
      if (k > 0) expected += list[k] * (list[k] - list[k - 1]) / 2;
    }
    RC_ASSERT(t * t / 2 - stepped(find_integrator("adams-bashforth-2"), list, 0, 0, 1).back().first ==
              expected);
  }));
}

TEST_CASE("unrolled in letters, symplectic Euler's sum of squares can be seen") {
  const std::vector<Expr> missing = unrolled_shortfalls(find_integrator("symplectic-euler"), 3);
  REQUIRE(missing.size() == 3);
  CHECK(print(missing[2]) == "-1/2*h_1^2*a - 1/2*h_2^2*a - 1/2*h_3^2*a");
  for (const Expr& e : unrolled_shortfalls(find_integrator("rk4"), 3)) CHECK(is_number(e, 0));
}

TEST_CASE("what is said to be exact for every list is so for random ones, and nothing else is") {
  const std::vector<Steps> lists = {{Rational(1, 50), Rational(1, 20), Rational(1, 70), Rational(1, 9)},
                                    {Rational(1, 3), Rational(1, 100), Rational(1, 7), Rational(1, 50), 2}};
  int exact = 0;
  for (const Program& program : testing::undamped_catalogue()) {
    CAPTURE(program.name);
    if (!rational(program) || program.approximate()) continue;
    bool always = true;
    for (const Steps& list : lists) {
      Rational t;
      const auto frames = stepped(program, list, Rational(1, 3), 5, Rational(-981, 100));
      for (std::size_t n = 0; n < list.size(); ++n) {
        t += list[n];
        if (frames[n].first != Rational(1, 3) + 5 * t - Rational(981, 200) * t * t) always = false;
      }
    }
    const ListExactness found = list_exactness(program);
    REQUIRE(found.exact.has_value());
    CHECK(*found.exact == always);
    CHECK(found.shortfall.empty() == always);
    exact += always ? 1 : 0;
  }
  CHECK(exact >= 15);
}

TEST_CASE("with its square term a step is exact for every list") {
  for (const Program& original : testing::undamped_catalogue())
    for (int count : {1, 3}) {
      if (original.approximate()) continue;
      const Program program = substepped(original, count);
      const VariableSteps steps = variable_steps(program);
      if (!steps.law || !steps.law->only_squares() || steps.law->exact()) {
        CHECK_THROWS_AS(with_square_term(program, steps), Undefined);
        continue;
      }
      CAPTURE(program.name);
      const Program corrected = with_square_term(program, steps);
      CHECK(list_exactness(corrected).exact == true);
      const Steps list{Rational(1, 50), Rational(1, 3), Rational(1, 70)};
      Rational t;
      for (const Rational& h : list) t += h;
      CHECK(stepped(corrected, list, 1, 2, 3).back().first == 1 + 2 * t + Rational(3, 2) * t * t);
      CHECK(print(parse(print(corrected), "again")) == print(corrected));
    }
}

}  // namespace
}  // namespace shortfall
