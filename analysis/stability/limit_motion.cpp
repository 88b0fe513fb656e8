// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/limit_motion.hpp"

#include <algorithm>

#include "analysis/motion/formula_text.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/stability/letter_formula.hpp"

namespace shortfall {

namespace {

/// The sum of coefficient * letter over x0 and v0.
Expr combination(const Fraction& of_x0, const Fraction& of_v0) {
  const FormulaLetters letters{{{kCount, "n"}, {kStepLetter, "h"}}, {}};
  return joined(letter_formula(of_x0, letters, name("x0")), letter_formula(of_v0, letters, name("v0")));
}

Fraction coefficient_of(const Sequence& sequence, const Fraction& base) {
  for (const Sequence::Term& t : sequence.terms())
    if (t.base == base) return t.coefficient;
  return {};
}

std::vector<Fraction> bases(const Motion& motion) {
  std::vector<Fraction> result;
  for (const Sequence& column : motion)
    for (const Sequence::Term& t : column.terms())
      if (std::ranges::find(result, t.base) == result.end()) result.push_back(t.base);
  return result;
}

Expr formula_of(const Motion& motion) {
  Expr total = number(0);
  for (const Fraction& base : bases(motion)) {
    const Expr part = combination(coefficient_of(motion[0], base), coefficient_of(motion[1], base));
    if (base == Fraction(1)) {
      total = joined(total, part);
      continue;
    }
    const Expr power_of_base =
        binary(Expression::Op::power, letter_formula(base, {{{kStepLetter, "h"}}, {}}), name("n"));
    total = joined(total, is_number(part, 1) ? power_of_base : power_of_base * part);
  }
  return total;
}

/// The coefficient of the highest power of n, over all bases on the unit circle, with whole numbers.
Expr growth_of(const Motion& motion) {
  int degree = 0;
  for (const Sequence& column : motion)
    for (const Sequence::Term& t : column.terms())
      degree = std::max(degree, t.coefficient.numerator().degree(kCount));
  if (degree == 0) return number(0);
  for (const Fraction& base : bases(motion)) {
    std::vector<Fraction> leading;
    for (const Sequence& column : motion) {
      const Fraction c = coefficient_of(column, base);
      leading.emplace_back(c.numerator().coefficient(kCount, degree), c.denominator());
    }
    if (leading[0].is_zero() && leading[1].is_zero()) continue;
    // Up to a factor: x0 alone, v0 alone, or x0 with a positive whole coefficient.
    if (leading[1].is_zero()) return name("x0");
    if (leading[0].is_zero()) return name("v0");
    const Fraction ratio = leading[1] / leading[0];
    Rational common = 1;
    for (const Polynomial::Term& t : ratio.numerator().terms())
      common *= (common * t.coefficient).denominator();
    return combination(Fraction(ratio.denominator()) * Fraction(common),
                       Fraction(ratio.numerator()) * Fraction(common));
  }
  return number(0);
}

}  // namespace

std::optional<LimitMotion> limit_motion(const Program& program, const Values& parameters, int substeps,
                                        const Rational& y) {
  const Program frame = substeps == 1 ? program : substepped(program, substeps);
  const StepMap map = step_map(lower(frame, parameters), -1, Fraction(y) / Fraction::letter(kStepLetter, 2));
  if (!map.extras.empty()) return std::nullopt;  // irrational coefficients
  const ClosedForm form = closed_form(map);
  if (!form.oscillation.is_zero()) return std::nullopt;
  LimitMotion result;
  result.position = formula_of(form.position);
  result.velocity = formula_of(form.velocity);
  result.position_growth = growth_of(form.position);
  result.velocity_growth = growth_of(form.velocity);
  result.valid_from = form.valid_from;
  result.proved = prove(map, form).proved;
  return result;
}

}  // namespace shortfall
