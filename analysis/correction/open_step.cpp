// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/open_step.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/stability/motion_pair.hpp"

namespace shortfall {

namespace {

/// Whether a factor has the root 1 where there is no force, and nothing that the integrator damps by itself.
bool belongs_to_motion(Polynomial factor, const BranchPoint& units) {
  for (const auto& [letter, value] : units) factor = factor.substitute(letter, value);
  return Fraction(factor.substitute(kStiffness, Rational(0))
                      .substitute(kDamping, Rational(0))
                      .substitute(kStepLetter, Rational(0))
                      .substitute(kEigenvalue, Rational(1)))
      .is_zero();
}

void split(OpenStep& step) {
  const BranchPoint units = step.small_step_values();
  MotionPair found = motion_pair(characteristic_polynomial(step.matrix),
                                 [&](const Polynomial& factor) { return belongs_to_motion(factor, units); });
  step.zeros = found.zeros;
  step.nonzero = std::move(found.nonzero);
  step.pair = std::move(found.pair);
}

/// That the polynomial parts of the closed form are a motion: q(n+1) = M q(n) + push(n). Everything that is
/// built on them is built on this.
void check_particular(const OpenStep& step) {
  const Fraction next = Fraction::letter(kCount) + Fraction(1);
  for (int d = 0; d <= step.map.force.degree; ++d)
    for (int s = 0; s < step.states(); ++s) {
      Fraction right = step.map.step[s][step.map.force.force_column(d)];
      for (int j = 0; j < step.states(); ++j)
        if (!step.matrix[s][j].is_zero()) right += step.matrix[s][j] * step.state(j, d);
      if (!(step.state(s, d).substitute(kCount, next) == right))
        throw Error("a particular motion does not survive substitution");
    }
}

}  // namespace

BranchPoint OpenStep::small_step_values() const {
  BranchPoint values;
  for (const ExtraLetters::Extra& e : map.extras) {
    if (e.root) continue;
    const Fraction& exponent = e.function == Function::pow ? e.b : e.a;
    if ((e.function == Function::exp || e.function == Function::pow) &&
        exponent.substitute(kStepLetter, Fraction(0)).is_zero())
      values.emplace_back(e.letter, 1);
  }
  return values;
}

Fraction OpenStep::start(int s, int column) const {
  return map.start[s][column < 2 ? column : map.force.force_column(column - 2)];
}

OpenStep open_step(const Program& program, const Force& force, const Values& given, int substeps,
                   const std::vector<Replacement>& own) {
  OpenStep step;
  step.map =
      step_map(lower(substepped(program, substeps), given), force.degree, force.stiffness(), force.damping());
  for (const auto& [letter, value] : own) {
    for (auto* rows : {&step.map.start, &step.map.step})
      for (LinearForm& row : *rows) row = row.substitute(letter, value);
    step.map.position = step.map.position.substitute(letter, value);
    step.map.velocity = step.map.velocity.substitute(letter, value);
  }
  const NumberField field(step.map.generators);
  step.form = closed_form(step.map);
  step.matrix = step.map.matrix();
  split(step);
  check_particular(step);
  return step;
}

}  // namespace shortfall
