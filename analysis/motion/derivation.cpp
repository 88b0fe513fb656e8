// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/derivation.hpp"

#include <algorithm>
#include <random>

#include "analysis/motion/derivation_steps.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kHighestDegree = 1000;
constexpr int kHighestProved = 200;  // about ten seconds for a method without parameters

/// Steps random rational numbers and holds the closed form against them: no letters, no linear forms, another
/// interpreter's problem.
RandomCheck random_check(const Tape& tape, const Program& program, const Values& given, const Derivation& d) {
  constexpr int kTrials = 3;
  RandomCheck check{kTrials, std::min(8, d.form.valid_from + 6), true};
  std::mt19937 random(20240808);
  const auto draw = [&] {
    return Rational(std::uniform_int_distribution<int>(-40, 40)(random),
                    std::uniform_int_distribution<int>(1, 9)(random));
  };
  const Values parameters = parameter_values(program, given);
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<Rational> column{draw(), draw()};
    for (int i = 0; i <= d.degree; ++i) column.push_back(draw());
    const Rational h = Rational(1, std::uniform_int_distribution<int>(2, 60)(random));
    std::map<Letter, Rational> letters{{kStepLetter, h}, {kStiffness, 0}, {kDamping, 0}, {kTimeLetter, 0}};
    for (std::size_t i = 0; i < tape.parameters.size(); ++i)
      letters[kFirstParameter + static_cast<int>(i)] = parameters.at(tape.parameters[i].name);
    Numbers<Rational> problem{[&](const Rational&, const Rational&, const Rational& t) {
      Rational f;
      for (int i = d.degree; i >= 0; --i) f = f * t + column[2 + i];
      return f;
    }};
    Run<Numbers<Rational>> run(tape, problem, h);
    run.begin(column[0], column[1], 0);
    for (int n = 0; n <= check.steps; ++n) {
      if (n > 0) run.step();
      if (n < d.form.valid_from) continue;
      const auto [x, v] = run.read_out();
      letters[kCount] = n;
      for (const auto& [stepped, motion] : {std::pair{x, &d.form.position}, {v, &d.form.velocity}}) {
        Rational closed;
        for (std::size_t c = 0; c < motion->size(); ++c)
          for (const Sequence::Term& term : (*motion)[c].terms())
            closed += term.coefficient.evaluate(letters) * term.base.evaluate(letters).pow(n) * column[c];
        check.agrees = check.agrees && closed == stepped;
      }
    }
  }
  return check;
}

std::vector<std::string> assumed(const Derivation& d) {
  std::vector<std::string> result{
      "the force is " + std::string(d.degree == 0
                                        ? "constant, a"
                                        : "a polynomial in t of degree " + std::to_string(d.degree)),
      "every step has the same length h"};
  if (d.form.valid_from > 0)
    result.push_back("n >= " + std::to_string(d.form.valid_from) + ": before that, the start is still felt");
  for (const auto& [base, multiplicity] : d.form.spectrum)
    if (!base.is_constant())
      result.push_back("the eigenvalue " + base.str(d.map.letters) +
                       " of the step is a number: its denominator is not 0");
  return result;
}

}  // namespace

bool Derivation::proved() const {
  return proof.proved && check.agrees &&
         std::ranges::all_of(steps, [](const DerivationStep& s) { return s.proved; });
}

Derivation derivation(const Program& program, int degree, const Values& given, int substeps, bool tell) {
  if (degree < 0 || degree > kHighestDegree)
    throw BadInput("the degree of a force polynomial is a whole number from 0 to " +
                   std::to_string(kHighestDegree));
  if (degree > kHighestProved)
    throw Unable("the closed form is proved for every n by comparing it, letter by letter, at degree + 3 steps, which costs about the cube of "
                 "the degree; our limit is degree " + std::to_string(kHighestProved));
  const Program stepped_program = substepped(program, substeps);
  const Tape tape = lower(stepped_program, given);
  Derivation d;
  d.integrator = program.name;
  d.degree = degree;
  d.substeps = substeps;
  d.map = step_map(tape, degree);
  d.form = closed_form(d.map);
  if (!d.form.oscillation.is_zero())
    throw Unable(
        "an eigenvalue of the step is no rational function of its letters: without a force the body would "
        "oscillate");
  d.proof = prove(d.map, d.form);
  const Motion x = exact_position(degree);
  const Motion v = exact_velocity(degree);
  d.shortfall_position_motion = x - d.form.position;
  d.shortfall_velocity_motion = v - d.form.velocity;
  const Wording w = d.wording();
  d.position = formula(d.form.position, degree, w);
  d.velocity = formula(d.form.velocity, degree, w);
  d.exact_position = formula(x, degree, w);
  d.exact_velocity = formula(v, degree, w);
  d.shortfall_position = formula(d.shortfall_position_motion, degree, w);
  d.shortfall_velocity = formula(d.shortfall_velocity_motion, degree, w);
  d.check = random_check(tape, stepped_program, given, d);
  d.assumptions = assumed(d);
  if (tell) d.steps = derivation_steps(d, !tape.finish.empty());
  return d;
}

}  // namespace shortfall
