// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/letter_formula.hpp"

#include <algorithm>

#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

using LetterNames = std::vector<FormulaLetters::Name>;

Expr powers_of(const Monomial& monomial, const LetterNames& names) {
  Expr product = number(1);
  for (const auto& [letter, written, times] : names)
    product = product * power(name(written), times * monomial.exponent(letter));
  return product;
}

Monomial only(const Monomial& monomial, const LetterNames& names) {
  Monomial result;
  for (const auto& [letter, written, times] : names) result = result.with(letter, monomial.exponent(letter));
  return result;
}

/// a x y / u: a product whose parts may be products and quotients themselves.
Expr all_of(const Expr& coefficient, const Expr& middle, const Expr& times, const Expr& divisor) {
  Expr result = chained(coefficient, middle);
  if (times) result = result * times;
  return result / divisor;
}

/// The terms of p that share their powers of the sorting letters.
struct Group {
  Monomial powers;
  Polynomial coefficient;
};

std::vector<Group> groups(const Polynomial& p, const FormulaLetters& letters) {
  std::vector<Group> result;
  for (const Polynomial::Term& t : p.terms()) {
    const Monomial powers = only(t.monomial, letters.powers);
    auto found = std::ranges::find_if(result, [&](const Group& g) { return g.powers == powers; });
    if (found == result.end()) found = result.insert(result.end(), {powers, {}});
    found->coefficient += Polynomial::from_terms({{only(t.monomial, letters.parameters), t.coefficient}});
  }
  std::ranges::sort(result, [](const Group& a, const Group& b) {
    return a.powers.total_degree() != b.powers.total_degree()
               ? a.powers.total_degree() < b.powers.total_degree()
               : b.powers < a.powers;
  });
  return result;
}

Expr written(const Polynomial& p, const FormulaLetters& letters, const Expr& times = nullptr,
             const Expr& divisor = number(1)) {
  if (p.is_zero()) return number(0);
  const std::vector<Group> parts = groups(p, letters);
  if (times && parts.size() > 1) return all_of(number(1), written(p, letters), times, divisor);
  Expr total = number(0);
  for (const Group& g : parts) {
    const bool negative = g.coefficient.terms().front().coefficient.sign() < 0;
    const Polynomial size = negative ? -g.coefficient : g.coefficient;
    Expr coefficient = number(0);
    if (size.terms().size() == 1)
      coefficient = number(size.terms().front().coefficient) *
                    powers_of(size.terms().front().monomial, letters.parameters);
    else
      coefficient = written(size, {letters.parameters, {}});
    const Expr part = all_of(coefficient, powers_of(g.powers, letters.powers), times, divisor);
    total = negative ? total - part : total + part;
  }
  return total;
}

/// A factor with whole coefficients whose lowest term is positive; what that takes goes to the constant.
Polynomial whole(const Polynomial& p, int multiplicity, const FormulaLetters& letters, Rational& constant) {
  Rational common = 1;
  for (const Polynomial::Term& t : p.terms()) common *= (common * t.coefficient).denominator();
  if (groups(p, letters).front().coefficient.terms().front().coefficient.sign() < 0) common = -common;
  constant /= common.pow(multiplicity);
  return p * Polynomial(common);
}

/// The factors of p, whose constant is taken out.
Expr factors_of(const Polynomial& p, const FormulaLetters& letters, Rational& constant) {
  const Factorization f = factor(p);
  constant = f.constant;
  Expr product = number(1);
  // Single letters first.
  for (const bool single : {true, false})
    for (const auto& [base, multiplicity] : f.factors)
      if ((base.terms().size() == 1) == single)
        product = chained(
            product, power(written(whole(base, multiplicity, letters, constant), letters), multiplicity));
  return product;
}

}  // namespace

Expr letter_formula(const Fraction& f, const FormulaLetters& letters, const Expr& times) {
  if (f.is_zero()) return number(0);
  if (f.denominator().terms().size() == 1)
    return written(f.numerator(), letters, times, written(f.denominator(), letters));
  Rational above, below;
  const Expr numerator = factors_of(f.numerator(), letters, above),
             denominator = factors_of(f.denominator(), letters, below);
  const Rational constant = above / below;
  Expr top = chained(number(constant.numerator().abs()), numerator);
  if (times) top = top * times;
  const Expr quotient = top / chained(number(constant.denominator()), denominator);
  return constant.sign() < 0 ? negate(quotient) : quotient;
}

}  // namespace shortfall
