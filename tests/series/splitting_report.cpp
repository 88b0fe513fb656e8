// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_report.hpp"

#include <doctest/doctest.h>

#include <string>
#include <tuple>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/transform.hpp"

using namespace shortfall;

namespace {

const BracketTerm* term(const std::vector<BracketTerm>& terms, const std::string& bracket) {
  for (const BracketTerm& t : terms)
    if (t.bracket == bracket) return &t;
  return nullptr;
}

}  // namespace

TEST_CASE(
    "orders of the catalogue's splittings, for any two fields and for x'' = a(x), are the published ones") {
  // From the sources that the files name.
  const std::vector<std::tuple<std::string, int, int>> known{{"symplectic-euler", 1, 1},
                                                             {"symplectic-euler-drift-kick", 1, 1},
                                                             {"velocity-verlet", 2, 2},
                                                             {"position-verlet", 2, 2},
                                                             {"ruth3", 3, 3},
                                                             {"forest-ruth", 4, 4},
                                                             {"yoshida4", 4, 4},
                                                             {"suzuki4", 4, 4},
                                                             {"mclachlan-atela-2", 2, 2},
                                                             {"mclachlan-atela-3", 3, 3},
                                                             {"mclachlan-atela-4", 3, 4},
                                                             {"mclachlan-s2", 2, 2},
                                                             {"mclachlan-s4", 4, 4},
                                                             {"mclachlan-s5", 4, 4},
                                                             {"mclachlan-sb3a", 4, 4},
                                                             {"pefrl", 4, 4},
                                                             {"yoshida6", 6, 6},
                                                             {"blanes-moan-s6", 4, 4},
                                                             {"blanes-moan-s10", 6, 6},
                                                             {"blanes-moan-rkn6", 4, 4},
                                                             {"blanes-moan-rkn11", 4, 6},
                                                             {"blanes-moan-rkn14", 4, 6}};
  for (const auto& [word, any, mechanical] : known) {
    const std::string name = word;
    const SplittingReport report = splitting_report(find_integrator(name), 7);
    CHECK_MESSAGE(report.any.order == any, name);
    CHECK_MESSAGE(report.mechanical.order == mechanical, name);
    CHECK_MESSAGE(report.any.order_is_exact, name);
    CHECK_MESSAGE(report.mechanical.order_is_exact, name);
    CHECK(report.proved == !find_integrator(name).approximate());
    CHECK(report.any.zero_to_digits.has_value() == !report.proved);
    if (!report.proved) CHECK_MESSAGE(*report.any.zero_to_digits >= 10, name);
  }
}

TEST_CASE("the report on symplectic Euler says what velocity Verlet has to do with it") {
  const SplittingReport report = splitting_report(find_integrator("symplectic-euler"), 4);
  CHECK(report.proved);
  REQUIRE(report.step.size() == 2);
  CHECK(report.step[0].kick);
  CHECK(term(report.any.modified, "[A,B]")->coefficient.exact == "-1/2");
  CHECK(report.any.order == 1);
  CHECK(report.any.effective_order == 2);
  CHECK(report.any.effective_order_is_exact);
  REQUIRE(report.any.corrector.size() == 1);
  CHECK(report.any.corrector[0].bracket == "B");
  CHECK(report.any.corrector[0].coefficient.exact == "-1/2");
  CHECK(report.any.obstruction_degree == 3);
  REQUIRE(report.any.obstructions.size() == 1);
  CHECK(report.any.obstructions[0].value.exact == "1/24");
  REQUIRE(report.any.obstructions[0].functional.size() == 2);
  CHECK(term(report.any.obstructions[0].functional, "[A,[A,B]]")->coefficient.exact == "1");
  CHECK(term(report.any.obstructions[0].functional, "[[A,B],B]")->coefficient.exact == "1");
}

TEST_CASE("algebraic coefficients are those of 60-digit rationals, to 20 digits") {
  for (const char* name :
       {"yoshida4", "forest-ruth", "suzuki4", "mclachlan-s4", "mclachlan-atela-3", "mclachlan-s2"}) {
    const Program program = find_integrator(name);
    const SplittingReport exact = splitting_report(program, 6);
    CHECK_FALSE(exact.generator.empty());
    if (program.roots.empty()) continue;  // square roots stay in the text
    const SplittingReport rounded = splitting_report(with_numbers(program, 60), 6);
    for (const BracketTerm& t : exact.any.modified) {
      const BracketTerm* other = term(rounded.any.modified, t.bracket);
      REQUIRE(other != nullptr);
      CHECK_MESSAGE(t.coefficient.decimal == other->coefficient.decimal, name << " " << t.bracket);
      CHECK_FALSE(t.coefficient.exact.empty());
    }
  }
}

TEST_CASE("a coefficient with the generator is written as an expression of the language") {
  const SplittingReport report = splitting_report(find_integrator("mclachlan-s4"), 5);
  CHECK(report.step[0].weight.exact == "107/654 + 1/3924*sqrt(471)");
  CHECK(report.step[0].weight.decimal == "0.16913927992207204518");
}

TEST_CASE("known digits are not dressed up as exact") {
  const SplittingReport report = splitting_report(find_integrator("yoshida6"), 7);
  CHECK_FALSE(report.proved);
  CHECK(report.generator.empty());
  CHECK(report.step[0].weight.exact.empty());
  CHECK(report.step[0].weight.digits >= 13);
  CHECK(report.step[0].weight.decimal.starts_with("0.392256805"));
  for (const BracketTerm& t : report.any.modified) CHECK((t.degree == 1 || t.degree == 7));
}

TEST_CASE("what is no splitting says why and nothing else") {
  const SplittingReport report = splitting_report(find_integrator("rk4"), 4);
  CHECK(report.why_not == "no kicks and drifts lead to the position of force evaluation 2");
  CHECK(report.step.empty());
  CHECK_FALSE(report.proved);
}

TEST_CASE("degrees beyond the table are refused") {
  CHECK_THROWS_AS(splitting_report(find_integrator("ruth3"), 13), Unable);
  CHECK_THROWS_AS(splitting_report(find_integrator("ruth3"), 1), Unable);
}

TEST_CASE("the force report on velocity Verlet is a + h^2/12 a_x[a], and why order 6 is out of reach") {
  const SplittingForceReport report = splitting_force_report(find_integrator("velocity-verlet"), 6);
  CHECK(report.proved);
  REQUIRE(report.kick.size() == 2);
  CHECK(term(report.kick, "B")->coefficient.exact == "1");
  CHECK(term(report.kick, "[[A,B],B]")->coefficient.exact == "-1/24");
  CHECK(report.processed.effective_order == 4);
  CHECK(report.processed.effective_order_is_exact);
  REQUIRE(report.processed.corrections.size() == 3);
  CHECK(term(report.processed.corrections[1], "[A,B]")->coefficient.exact == "1/12");
  REQUIRE(report.limit);
  CHECK(report.limit->degree == 5);
  CHECK(report.limit->conditions == 2);
  CHECK(report.limit->unknowns == 1);
  CHECK(report.limit->conclusive);
  CHECK(report.limit->residual.exact == "-1/1440");
}

TEST_CASE("force corrections of splittings with algebraic weights and with published digits") {
  const SplittingForceReport exact = splitting_force_report(find_integrator("mclachlan-s2"), 5);
  CHECK(exact.proved);
  CHECK(exact.processed.effective_order == 4);
  CHECK_FALSE(term(exact.kick, "[[A,B],B]")->coefficient.exact.empty());
  const SplittingForceReport digits = splitting_force_report(find_integrator("mclachlan-atela-4"), 5);
  CHECK_FALSE(digits.proved);
  CHECK(digits.processed.effective_order >= 4);
  CHECK(splitting_force_report(find_integrator("rk4"), 5).why_not ==
        "no kicks and drifts lead to the position of force evaluation 2");
}

TEST_CASE("parameters take the values that are given") {
  const Program program = parse(
      "integrator test\n  param s = 1/2\nsplitting\n  kick s\n  drift 1\n  kick 1 - s\n", "test.integrator");
  CHECK(splitting_report(program, 4).any.order == 2);
  const SplittingReport other = splitting_report(program, 4, {{"s", Rational(1, 3)}});
  CHECK(other.any.order == 1);
  CHECK(other.step[0].weight.exact == "1/3");
}
