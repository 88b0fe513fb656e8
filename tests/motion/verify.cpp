// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/verify.hpp"

#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

Verdict verdict_on(const char* integrator, int degree, const char* formula, const Values& given = {}) {
  const Program p = find_integrator(integrator);
  const Expr claimed = parse_formula(formula, "--x", formula_names(p, degree), {Sort::vector, kLength});
  return verdict(derivation(p, degree, given, 1, false), p, given, claimed, true);
}

}  // namespace

TEST_CASE("a formula that the start refutes is said to hold from then on") {
  const Program program = find_integrator("adams-bashforth-2");
  const Derivation d = derivation(program, 1);
  const Verdict v = verdict(d, program, {}, d.position, true);
  CHECK_FALSE(v.proved);
  REQUIRE(v.counter_example);
  CHECK(v.counter_example->n == 0);
  CHECK(v.holds_from == 1);
  CHECK(v.found_from == 1);
  const Verdict never = verdict(d, program, {}, d.position + name("x0"), true);
  CHECK_FALSE(never.holds_from);
}

TEST_CASE("a right formula is proved in whatever way it is written") {
  CHECK(verdict_on("symplectic-euler", 0, "x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t").proved);
  CHECK(verdict_on("symplectic-euler", 0, "x0 + h*(v0*n + a*h*n*(n + 1)/2)").proved);
  CHECK(verdict_on("velocity-verlet", 1, "x0 + v0*t + f0*t^2/2 + f1*t*(t^2 - h^2)/6").proved);
}

TEST_CASE("where a formula divides by zero is said, and is no reason to refute it") {
  const auto gaps = [](const char* formula) {
    const Verdict v = verdict_on("symplectic-euler", 0, formula);
    CHECK(v.proved);
    return v.gaps;
  };
  CHECK(gaps("x0 + v0*t + 1/2*a*t^2*(n + 1)/n").counts == std::vector<Rational>{0});
  CHECK(gaps("x0 + v0*t + 1/2*a*t*(t + h)*(n - 1)/(n - 1)*(n - 10)^-2*(n - 10)^2*(1/n)^-1/n").counts ==
        std::vector<Rational>{0, 1, 10});
  CHECK(gaps("x0 + v0*t + 1/2*a*t*(t + h)*(n + 1)/(n + 1)*(n^2 - 2)/(n^2 - 2)*(n - 1/2)/(2*n - 1)*2")
            .counts.empty());
  CHECK_FALSE(gaps("x0 + v0*t + 1/2*a*t*(t + h)").of_letters);
  // (n - 1) h k - (n - 1) vanishes at n = 1 whatever h and k are.
  const Program p = find_integrator("newmark");
  const Expr claimed = parse_formula("x0*((n - 1)*beta*gamma - (n - 1))/((n - 1)*(beta*gamma - 1)) + 0*v0",
                                     "--x", formula_names(p, 0), {Sort::vector, kLength});
  const FormulaGaps found = formula_gaps(claimed, formula_scalars(p), 0);
  CHECK(found.counts == std::vector<Rational>{1});
  CHECK(found.of_letters);
  const Verdict wrong = verdict_on("symplectic-euler", 0, "x0/n + v0*t");
  REQUIRE(wrong.counter_example);
  CHECK(wrong.counter_example->n == 1);
}

TEST_CASE("a wrong formula is refuted at the smallest n, with numbers that show it") {
  const Verdict v = verdict_on("symplectic-euler", 0, "x0 + v0*t + a*t^2");
  CHECK_FALSE(v.proved);
  REQUIRE(v.counter_example);
  CHECK(v.counter_example->n == 2);
  // kick and drift by hand, with the values given
  const Rational h = v.counter_example->values.at("h");
  const Rational a = v.counter_example->values.at("a");
  CHECK(v.counter_example->computed == Rational(3) * a * h * h);
  CHECK(v.counter_example->claimed == Rational(4) * a * h * h);
}

TEST_CASE("a formula that is wrong at n = 0 is refuted there") {
  const Verdict v = verdict_on("rk4", 0, "x0 + h*v0 + v0*t + 1/2*a*t^2");
  REQUIRE(v.counter_example);
  CHECK(v.counter_example->n == 0);
}

TEST_CASE("a formula that holds from n = 1 on only is refuted at n = 0, or proved by the true start") {
  const Verdict v =
      verdict_on("adams-bashforth-2", 1, "x0 + v0*t + f0*t^2/2 + f1*t^3/6 - 5/12*f1*h^2*t + 1/4*f1*h^3");
  CHECK_FALSE(v.proved);
  REQUIRE(v.counter_example);
  CHECK(v.counter_example->n == 0);
}
