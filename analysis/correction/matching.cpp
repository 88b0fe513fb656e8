// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/matching.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/stability/resultant.hpp"

namespace shortfall {

namespace {

Fraction at(Polynomial p, const BranchPoint& point) {
  for (const auto& [letter, value] : point) p = p.substitute(letter, value);
  return p;
}

/// Whether polynomials contain algebraic numbers: then a greatest common divisor over the rationals may miss
/// factors.
bool in_number_field(const std::vector<Fraction>& conditions) {
  if (!NumberField::current()) return false;
  for (const NumberField::Generator& g : NumberField::current()->generators())
    for (const Fraction& f : conditions)
      if (f.contains(g.letter)) return true;
  return false;
}

/// Whether an equation holds at the point, and has a simple root there.
bool on_branch(const Polynomial& equation, Letter unknown, const BranchPoint& point) {
  const Polynomial part = small_step_part(equation);
  return at(part, point).is_zero() && !at(part.derivative(unknown), point).is_zero();
}

/// Whether a value of the unknown is that of the solution that is wanted.
bool on_branch(const Fraction& value, Letter unknown, const BranchPoint& point) {
  return on_branch(value.denominator() * Polynomial::letter(unknown) - value.numerator(), unknown, point);
}

/// The value of a letter from an equation that is linear in it; empty when it is not.
std::optional<Fraction> solved_for(const Fraction& equation, Letter unknown) {
  if (equation.numerator().degree(unknown) != 1) return std::nullopt;
  return -Fraction(equation.numerator().coefficient(unknown, 0),
                   equation.numerator().coefficient(unknown, 1));
}

bool all_zero(const std::vector<Fraction>& conditions, const Matching& m) {
  return std::ranges::all_of(conditions, [&](const Fraction& f) { return m.put_into(f).is_zero(); });
}

/// The factor that vanishes at the point; a product of such factors when there are several.
Polynomial branch_factor(const Polynomial& p, const BranchPoint& point) {
  Polynomial result = 1;
  for (const auto& [factor, multiplicity] : factor(p).factors)
    if (at(small_step_part(factor), point).is_zero()) result = result * factor.pow(multiplicity);
  return result;
}

Matching one_unknown(const std::vector<Fraction>& conditions, Letter unknown, const BranchPoint& point,
                     const std::vector<std::string>& names) {
  Matching m{Matching::Kind::impossible, {unknown}, {}, {}, {}, false};
  Polynomial common;
  for (const Fraction& condition : conditions) {
    if (!condition.is_zero() && !condition.contains(unknown)) {
      m.obstruction = "no choice of " + names[unknown] + " changes the difference " + condition.str(names);
      return m;
    }
    common = gcd(common, condition.numerator());
  }
  if (common.degree(unknown) < 1) {
    // There a greatest common divisor over the rationals may miss a factor; the resultant does not.
    if (in_number_field(conditions) &&
        (conditions.size() != 2 ||
         Fraction(resultant(conditions[0].numerator(), conditions[1].numerator(), unknown)).is_zero())) {
      m.kind = Matching::Kind::unknown;
      m.obstruction = "both conditions on " + names[unknown] +
                      " contain algebraic numbers, and common factors are looked for over the rationals only";
      return m;
    }
    m.obstruction =
        "no value of " + names[unknown] + " satisfies both conditions (their greatest common divisor is 1)";
    return m;
  }
  for (const auto& [factor, multiplicity] : factor(common).factors) {
    if (factor.degree(unknown) != 1) continue;
    m.values = {-Fraction(factor.coefficient(unknown, 0), factor.coefficient(unknown, 1))};
    // The only root there is needs no branch.
    m.only = common.degree(unknown) == 1;
    if (m.only || on_branch(factor, unknown, point)) {
      m.kind = Matching::Kind::rational;
      return m;
    }
    m.values.clear();
  }
  m.equations = {branch_factor(common, point)};
  m.kind = m.equations[0].contains(unknown) ? Matching::Kind::algebraic : Matching::Kind::unknown;
  if (m.kind == Matching::Kind::unknown)
    m.obstruction =
        "no root of the condition on " + names[unknown] + " tends to the true value for small steps";
  return m;
}

}  // namespace

Polynomial small_step_part(const Polynomial& p) {
  const auto order = [](const Polynomial::Term& t) {
    return t.monomial.exponent(kStepLetter) - 2 * t.monomial.exponent(kStiffness) -
           t.monomial.exponent(kDamping);
  };
  if (p.is_zero()) return p;
  int least = order(p.terms().front());
  for (const Polynomial::Term& t : p.terms()) least = std::min(least, order(t));
  std::vector<Polynomial::Term> kept;
  for (const Polynomial::Term& t : p.terms())
    if (order(t) == least) kept.push_back({t.monomial.without(kStepLetter), t.coefficient});
  return Polynomial::from_terms(std::move(kept));
}

Fraction Matching::put_into(Fraction f) const {
  for (std::size_t i = 0; i < values.size(); ++i) f = f.substitute(unknowns[i], values[i]);
  return f;
}

Matching matching(const std::vector<Fraction>& conditions, const std::vector<Letter>& unknowns,
                  const BranchPoint& point, const std::vector<std::string>& names) {
  if (unknowns.size() == 1) return one_unknown(conditions, unknowns[0], point, names);
  for (const Fraction& condition : conditions)
    if (!condition.is_zero() && !condition.contains(unknowns[0]) && !condition.contains(unknowns[1])) {
      Matching m{Matching::Kind::impossible, unknowns, {}, {}, {}, false};
      m.obstruction = "no choice of " + names[unknowns[0]] + " and " + names[unknowns[1]] +
                      " changes the difference " + condition.str(names);
      return m;
    }
  // Eliminate one unknown by an equation that is linear in it, then solve the other equation for the second.
  for (const std::size_t eliminated : {std::size_t{1}, std::size_t{0}})
    for (const std::size_t by : {std::size_t{0}, std::size_t{1}}) {
      const std::optional<Fraction> value = solved_for(conditions[by], unknowns[eliminated]);
      if (!value) continue;
      const Matching inner = one_unknown({conditions[1 - by].substitute(unknowns[eliminated], *value)},
                                         unknowns[1 - eliminated], point, names);
      // The eliminated unknown has this value and no other, where its coefficient is not 0 whatever the
      // second is.
      const bool always =
          !conditions[by].numerator().coefficient(unknowns[eliminated], 1).contains(unknowns[1 - eliminated]);
      if (inner.kind == Matching::Kind::impossible && always) {
        Matching m{Matching::Kind::impossible, unknowns, {}, {}, {}, false};
        m.obstruction = "with " + names[unknowns[eliminated]] + " = " + value->str(names) +
                        " from one condition, " + inner.obstruction;
        return m;
      }
      if (inner.kind != Matching::Kind::rational) continue;
      Matching m{Matching::Kind::rational, unknowns, std::vector<Fraction>(2), {}, {}, false};
      try {
        m.values[1 - eliminated] = inner.values[0];
        m.values[eliminated] = inner.put_into(*value);
        m.only = inner.only && always;
        if (all_zero(conditions, m) && (m.only || (on_branch(m.values[0], unknowns[0], point) &&
                                                   on_branch(m.values[1], unknowns[1], point))))
          return m;
      } catch (const Undefined&) {
        // The eliminated unknown has no value there.
      }
    }
  Matching m{Matching::Kind::algebraic, unknowns, {}, {}, {}, false};
  for (const Fraction& condition : conditions)
    m.equations.push_back(branch_factor(condition.numerator(), point));
  for (const Polynomial& p : m.equations)
    if (p.is_constant()) {
      m.kind = Matching::Kind::unknown;
      m.obstruction =
          "a condition does not hold in the limit of small steps: the integrator is not consistent";
    }
  return m;
}

Fraction branch_jacobian(const Matching& m, const BranchPoint& point) {
  std::vector<Fraction> d;
  for (const Polynomial& equation : m.equations)
    for (const Letter unknown : m.unknowns)
      d.push_back(at(small_step_part(equation).derivative(unknown), point));
  return d.size() == 1 ? d[0] : d[0] * d[3] - d[1] * d[2];
}

}  // namespace shortfall
