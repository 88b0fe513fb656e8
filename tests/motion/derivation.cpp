// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/derivation.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/motion/line_check.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"

using namespace shortfall;

namespace {

std::string position(const std::string& integrator, int degree = 0, int substeps = 1) {
  return print(derivation(find_integrator(integrator), degree, {}, substeps, false).position);
}

std::string shortfall_of(const std::string& integrator, int degree = 0, int substeps = 1) {
  return print(derivation(find_integrator(integrator), degree, {}, substeps, false).shortfall_position);
}

}  // namespace

TEST_CASE("symplectic Euler falls short of gravity's parabola by -a h t / 2") {
  CHECK(position("symplectic-euler") == "x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t");
  CHECK(shortfall_of("symplectic-euler") == "-1/2*a*h*t");
}

TEST_CASE("explicit Euler and drift-kick miss to the other side, second-order methods not at all") {
  CHECK(shortfall_of("explicit-euler") == "1/2*a*h*t");
  CHECK(shortfall_of("symplectic-euler-drift-kick") == "1/2*a*h*t");
  for (const char* name : {"velocity-verlet", "midpoint", "rk4", "newmark", "leapfrog"})
    CHECK(shortfall_of(name) == "0");
}

TEST_CASE("N substeps shorten the shortfall N times") {
  CHECK(shortfall_of("symplectic-euler", 0, 4) == "-1/8*a*h*t");
  CHECK(shortfall_of("symplectic-euler", 0, 10000) == "-1/20000*a*h*t");
}

TEST_CASE("every catalogue entry is derived and proved, line by line" * doctest::test_suite("thorough")) {
  for (const Program& p : catalogue())
    for (const int degree : {0, 1, 3}) {
      CAPTURE(p.name);
      CAPTURE(degree);
      const Derivation d = derivation(p, degree, {}, degree == 1 ? 3 : 1);
      CHECK(d.proved());
      CHECK(d.steps.size() >= 6);
      for (const DerivationStep& s : d.steps) {
        CAPTURE(print(s.left) + " = " + print(s.right));
        CHECK(s.proved);
      }
    }
}

TEST_CASE("results are formulas of the language: they can be read back and mean the same") {
  for (const Program& p : catalogue()) {
    CAPTURE(p.name);
    const Derivation d = derivation(p, 2, {}, 1, false);
    const NumberField field(d.map.generators);
    ExtraLetters* const extras = d.map.force.extras.get();
    const Names names = formula_names(p, 2);
    const Expr x = parse_formula(print(d.position), "x", names, {Sort::vector, kLength});
    const Expr v = parse_formula(print(d.shortfall_velocity), "v", names, {Sort::vector, kVelocity});
    CHECK(is_zero(evaluated(x, formula_scalars(p, {}, extras), 2, extras) - d.form.position));
    CHECK(is_zero(evaluated(v, formula_scalars(p, {}, extras), 2, extras) - d.shortfall_velocity_motion));
  }
}

TEST_CASE("a wrong line is not proved") {
  const Program p = find_integrator("symplectic-euler");
  const StepMap map = step_map(lower(p), 0);
  const auto quantities = story(map);
  const LineCheck check(map, quantities, 0, 6);
  const Expr x_n = name("x_n");
  const Names names = formula_names(p, 0);
  const auto formula = [&](const char* text) {
    return parse_formula(text, "test", names, {Sort::vector, kLength});
  };
  CHECK(check.agree(x_n, formula("x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t"), "n", 0, 5));
  CHECK_FALSE(check.agree(x_n, formula("x0 + v0*t + 1/2*a*t^2 - 1/2*a*h*t"), "n", 0, 5));
  // Agreement at the beginning alone is not enough: s(1) = u h + a h^2 holds for n = 1 only.
  CHECK(check.agree(x_n, formula("x0 + v0*t + a*t^2"), "n", 0, 1));
  CHECK_FALSE(check.agree(x_n, formula("x0 + v0*t + a*t^2"), "n", 0, 2));
}

TEST_CASE("sums in a line are added up as they stand, also where the upper end's letter is inside") {
  const StepMap map = step_map(lower(find_integrator("symplectic-euler")), 0);
  const std::vector<Quantity> quantities = story(map);
  const LineCheck check(map, quantities, 0, 12);
  const Expr n = name("n"), k = name("k"), h = name("h"), a = name("a");
  const auto over_k = [&](const Expr& body) { return sum("k", number(0), n - number(1), body); };
  const Expr gauss = n * (n - number(1)) / number(2);
  CHECK(check.agree(over_k(h * k * a), h * gauss * a, "n", 0, 9));
  CHECK_FALSE(check.agree(over_k(h * k * a), h * n * a, "n", 0, 9));
  CHECK(check.agree(over_k(h * n * k * a), h * n * gauss * a, "n", 0, 9));
  CHECK_FALSE(check.agree(over_k(h * n * k * a), h * gauss * a, "n", 0, 9));
  CHECK(check.agree(over_k(name("t") * a), n * n * h * a, "n", 0, 9));
  // Right up to n = 5 only.
  const Expr late =
      (n - number(1)) * (n - number(2)) * (n - number(3)) * (n - number(4)) * (n - number(5)) * n;
  CHECK(check.agree(over_k(h * k * a), h * (gauss + late) * a, "n", 0, 5));
  CHECK_FALSE(check.agree(over_k(h * k * a), h * (gauss + late) * a, "n", 0, 6));
  // A sum may also begin anew, and one sum may stand twice.
  CHECK(check.agree(over_k(h * a) + over_k(h * a), number(2) * h * n * a, "n", 3, 9));
}

TEST_CASE("a derivation tells how far it is, and the telling changes nothing") {
  const Program program = find_integrator("heun");
  std::vector<std::string> heard;
  bool in_order = true;
  const Progress progress = [&](const std::string& doing, int done, int of) {
    in_order = in_order && 0 <= done && done < of;
    if (heard.empty() || heard.back() != doing) heard.push_back(doing);
  };
  const Derivation d = derivation(program, 3, {}, 1, true, progress);
  CHECK(in_order);
  CHECK(std::ranges::count(heard, "proving a line") > 0);
  CHECK(std::ranges::count(heard, "stepping in letters") > 0);
  CHECK(std::ranges::count(heard, "summing up") > 0);
  CHECK(print(d.position) == position("heun", 3));
}

TEST_CASE("a wrong closed form is not proved") {
  const StepMap map = step_map(lower(find_integrator("velocity-verlet")), 1);
  ClosedForm form = closed_form(map);
  CHECK(prove(map, form).proved);
  form.position[3] += Sequence(Fraction(Rational(1, 1000)) * Fraction::letter(kCount));
  CHECK_FALSE(prove(map, form).proved);
}

TEST_CASE("a start that is still felt is said, and the formula is not claimed before") {
  const Derivation d = derivation(find_integrator("adams-bashforth-2"), 1);
  CHECK(d.form.valid_from == 1);
  CHECK(d.proved());
}

TEST_CASE("parameters stay letters, or take the user's value") {
  const Program newmark = find_integrator("newmark");
  CHECK(print(derivation(newmark, 1, {}, 1, false).shortfall_velocity) == "-gamma*f1*h*t + 1/2*f1*h*t");
  CHECK(print(derivation(newmark, 1, {{"gamma", Rational(1, 2)}}, 1, false).shortfall_velocity) == "0");
  CHECK_THROWS_WITH_AS(derivation(newmark, 0, {{"gama", 1}}),
                       "newmark has no parameter 'gama'; did you mean 'gamma'?", BadInput);
}

TEST_CASE(
    "a step with coefficients that depend on t, or with irrational eigenvalues, is refused with the reason") {
  const Program driven =
      parse("integrator driven\nparam w : 1/T = 1\nstep\n  x = x + h*v + h*t*w*v\n", "driven");
  CHECK_THROWS_AS(derivation(driven, 0), Unable);
  const Program rotating =
      parse("integrator rotating\nparam w : 1/T = 1\nstep\n  v = v - h*w^2*x\n  x = x + h*v\n", "rotating");
  CHECK_THROWS_AS(derivation(rotating, 0), Unable);
  CHECK_THROWS_AS(derivation(find_integrator("rk4"), 1001), BadInput);
}

TEST_CASE("geometric sums: a damped step") {
  const Program damped =
      parse("integrator damped\nparam q = 1/2\nstep\n  v = q*v + h*a(x, v, t)\n  x = x + h*v\n", "damped");
  const Derivation d = derivation(damped, 0);
  CHECK(d.proved());
  CHECK(d.form.spectrum.size() == 2);
}
