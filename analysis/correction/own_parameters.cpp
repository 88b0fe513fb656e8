// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/own_parameters.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall {

namespace {

/// The parameter of which a coefficient of the own equation is a multiple.
std::optional<OwnParameters::Tuned> tuned(const Program& program, const Values& given, Letter unknown) {
  const NumberField field;
  ExtraLetters extras(letter_names(lower(program, given)));
  const OwnEquation own = own_equation(program, given, extras);
  const FormulaScalars scalars = formula_scalars(program, given);
  for (const std::string& p : own.parameters) {
    const Fraction& value = scalars.at(p);
    const Fraction scale = (unknown == kStiffness ? own.stiffness : own.damping) / value;
    for (Letter letter = kFirstParameter; letter < kLetters; ++letter)
      if (value == Fraction::letter(letter) && !scale.is_zero() && !scale.contains(letter))
        return OwnParameters::Tuned{unknown, p, scale};
  }
  return std::nullopt;
}

}  // namespace

const OwnParameters::Tuned* OwnParameters::tuned_for(Letter unknown) const {
  for (const Tuned& t : tuned)
    if (t.unknown == unknown) return &t;
  return nullptr;
}

OwnParameters own_parameters(const Program& program, const Force& asked, const Values& given, int substeps) {
  OwnParameters result;
  result.force = asked;
  result.given = given;
  if (!program.solves) return result;
  const Force trial = without_own_equation(with_own_equation(asked, program, given));
  const StepMap map =
      step_map(lower(substepped(program, substeps), given), trial.degree, trial.stiffness(), trial.damping());
  const NumberField field(map.generators);
  result.force = with_own_equation(asked, program, given, *map.force.extras);
  if (result.force.own_c) result.decay = exact_decay(*result.force.own_c, map.force.extras->all());
  // The parameters are letters again where they are solved for.
  if (!result.force.own_k && (!result.force.own_c || result.decay)) return result;
  for (const Parameter& p : program.parameters)
    if (mentions(program.solves, p.name)) result.given.erase(p.name);
  for (const auto& [unknown, there] : {std::pair{kStiffness, result.force.own_k.has_value()},
                                       {kDamping, result.force.own_c.has_value() && !result.decay}}) {
    if (!there) continue;
    const auto found = tuned(program, result.given, unknown);
    if (!found)
      throw Unable("the equation that '" + program.name + "' solves, x'' = " + print(program.solves) +
                   ", has a coefficient that is no multiple of one parameter and that the step does not take "
                   "exactly; corrections are solved for where it is one or the other");
    result.tuned.push_back(*found);
    const Fraction letter = formula_scalars(program, result.given).at(found->name);
    for (Letter l = kFirstParameter; l < kLetters; ++l)
      if (letter == Fraction::letter(l))
        result.replacements.emplace_back(l, Fraction::letter(unknown) / found->scale);
  }
  return result;
}

int equal_parts(const Program& program, const Values& given, int substeps) {
  int parts = substeps;
  const Values values = parameter_values(program, given);
  for (const Statement& s : program.step) {
    if (s.kind != Statement::Kind::substeps) continue;
    const auto count =
        s.value->op == Expression::Op::name ? values.at(s.value->name) : literal_value(s.value).value_or(1);
    std::int64_t whole = 1;
    if (count.fits_int64(whole)) parts *= static_cast<int>(whole);
  }
  return parts;
}

}  // namespace shortfall
