// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/derivation.hpp"

#include <algorithm>

#include "analysis/motion/agreement.hpp"
#include "analysis/motion/derivation_steps.hpp"
#include "analysis/motion/force.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

constexpr int kHighestProved = 200;  // about ten seconds for a method without parameters

std::vector<std::string> assumed(const Derivation& d) {
  std::vector<std::string> result{
      "the force is " + std::string(d.degree == 0
                                        ? "constant, a"
                                        : "a polynomial in t of degree " + std::to_string(d.degree)),
      "every step has the same length h"};
  result.insert(result.end(), d.map.assumed.begin(), d.map.assumed.end());
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

Derivation derivation(const Program& program, int degree, const Values& given, int substeps, bool tell,
                      const Progress& progress) {
  if (degree < 0 || degree > kHighestForceDegree)
    throw BadInput("the degree of a force polynomial is a whole number from 0 to " +
                   std::to_string(kHighestForceDegree));
  if (degree > kHighestProved)
    throw Unable(
        "the closed form is proved for every n by comparing it, letter by letter, at degree + 3 steps, which "
        "costs about the cube of "
        "the degree; our limit is degree " +
        std::to_string(kHighestProved));
  const Program stepped_program = substepped(program, substeps);
  const Tape tape = lower(stepped_program, given);
  Derivation d;
  d.integrator = program.name;
  d.degree = degree;
  d.substeps = substeps;
  d.map = step_map(tape, degree);
  const NumberField field(d.map.generators);
  d.form = closed_form(d.map, progress);
  if (!d.form.oscillation.is_zero())
    throw Unable(
        "an eigenvalue of the step is no rational function of its letters: without a force the body would "
        "oscillate");
  d.proof = prove(d.map, d.form, progress);
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
  if (progress) progress("checking with random numbers", 0, 1);
  d.check = random_check(stepped_program, given, {}, d.map, d.form, 3, std::min(8, d.form.valid_from + 6));
  d.assumptions = assumed(d);
  d.digits = printed_digits(program);
  if (d.digits > 0) d.assumptions.push_back(about_printed_decimals(program));
  if (tell) d.steps = derivation_steps(d, !tape.finish.empty(), progress);
  return d;
}

}  // namespace shortfall
