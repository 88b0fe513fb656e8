// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_function.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/arithmetic.hpp"
#include "analysis/stability/amplification.hpp"

namespace shortfall {

namespace {

Rational value_of(const Expr& e, const Values& parameters);

/// Of what is no sum, product or quotient.
Rational leaf_value(const Expr& e, const Values& parameters) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t i) { return value_of(e->operands[i], parameters); };
  switch (e->op) {
    case Op::number:
      return e->value;
    case Op::power: {
      std::int64_t exponent = 0;
      if (operand(1).fits_int64(exponent) && exponent >= -1000 && exponent <= 1000)
        return operand(0).pow(static_cast<int>(exponent));
      break;
    }
    case Op::name:
      if (const auto found = parameters.find(e->name); found != parameters.end()) return found->second;
      break;
    default:
      break;
  }
  throw Unable("an entry of the tableau is no rational number");
}

Rational value_of(const Expr& e, const Values& parameters) {
  return arithmetic<Rational>(e, [&](const Expr& leaf) { return leaf_value(leaf, parameters); });
}

bool is_rational(const Tableau& tableau, const Values& parameters) {
  try {
    for (const auto& row : tableau.a)
      for (const Expr& e : row) value_of(e, parameters);
    for (const Expr& e : tableau.b) value_of(e, parameters);
    return true;
  } catch (const Unable&) {
    return false;
  }
}

/// det(1 - z M), from the characteristic polynomial of M.
Univariate<Rational> reciprocal_characteristic(const SquareMatrix<Rational>& m) {
  const std::vector<Rational> p = characteristic_coefficients(m);
  return std::vector<Rational>(p.rbegin(), p.rend());
}

/// In lowest terms over the field of the letters, each with the letters for its coefficients.
///
/// param   formula  P/Q, z in the letter of k
StabilityFunction over_field(const Fraction& formula, std::vector<std::string> names,
                             std::vector<AlgebraicLetter> letters) {
  std::erase_if(letters, [&](const AlgebraicLetter& l) { return !formula.contains(l.letter); });
  const CommonField field = common_field(letters);
  const auto p = over_field(formula.numerator(), kStiffness, letters, field),
             q = over_field(formula.denominator(), kStiffness, letters, field);
  const auto common = gcd(p, q);
  const auto above = divided(p, common).first, below = divided(q, common).first;
  if (below[0].is_zero()) throw Undefined("the stability function has a pole at 0");
  const Univariate<Algebraic> scale({Algebraic(1) / below[0]});
  StabilityFunction r{above * scale, below * scale,    field.generator,
                      formula,       std::move(names), std::move(letters)};
  if (r.algebraic.size() < 2) {
    // With one letter the field's numbers are polynomials in it.
    const auto in_letters = [&](const Univariate<Algebraic>& u) {
      Polynomial sum;
      for (int k = 0; k <= u.degree(); ++k) {
        const Polynomial c = r.algebraic.empty()
                                 ? Polynomial(u[k].rational())
                                 : Polynomial::in(r.algebraic[0].letter, u[k].polynomial().coefficients());
        sum += c * Polynomial::letter(kStiffness, k);
      }
      return Fraction(sum);
    };
    r.formula = in_letters(r.numerator) / in_letters(r.denominator);
  }
  return r;
}

/// p(M), entry by entry, for a p in the letter of k.
SquareMatrix<Fraction> in_matrix(const Polynomial& p, const SquareMatrix<Fraction>& m) {
  const std::vector<Polynomial> coefficients = p.coefficients(kStiffness);
  return evaluated(Univariate<Fraction>(std::vector<Fraction>(coefficients.begin(), coefficients.end())), m);
}

/// Even and odd part of p(iy): p(iy) = even(y^2) + i y odd(y^2).
std::pair<Univariate<Algebraic>, Univariate<Algebraic>> on_imaginary_axis(const Univariate<Algebraic>& p) {
  std::vector<Algebraic> even, odd;
  for (int k = 0; k <= p.degree(); ++k) (k % 2 == 0 ? even : odd).push_back(k / 2 % 2 == 0 ? p[k] : -p[k]);
  return {even, odd};
}

/// |p(iy)|^2 as a polynomial in y^2.
Univariate<Algebraic> squared_size(const Univariate<Algebraic>& p) {
  const auto [even, odd] = on_imaginary_axis(p);
  return even * even + Univariate<Algebraic>({0, 1}) * odd * odd;
}

/// p(y^2).
Univariate<Algebraic> in_square(const Univariate<Algebraic>& p) {
  std::vector<Algebraic> result;
  for (const Algebraic& c : p.coefficients()) {
    if (!result.empty()) result.emplace_back(0);
    result.push_back(c);
  }
  return result;
}

/// p(-z).
Univariate<Algebraic> mirrored(const Univariate<Algebraic>& p) {
  std::vector<Algebraic> result = p.coefficients();
  for (std::size_t k = 1; k < result.size(); k += 2) result[k] = -result[k];
  return result;
}

}  // namespace

Algebraic StabilityFunction::at(const Rational& z) const { return numerator.at(z) / denominator.at(z); }

std::optional<Algebraic> StabilityFunction::size_at_infinity() const {
  if (numerator.degree() > denominator.degree()) return std::nullopt;
  if (numerator.degree() < denominator.degree()) return Algebraic(0);
  return (numerator.leading() / denominator.leading()).abs();
}

StabilityFunction stability_function(const Univariate<Rational>& p, const Univariate<Rational>& q) {
  return over_field(
      Fraction(Polynomial::in(kStiffness, p.coefficients()), Polynomial::in(kStiffness, q.coefficients())),
      {}, {});
}

StabilityFunction stability_function(const Tableau& tableau, const Values& parameters) {
  const std::size_t stages = tableau.b.size();
  SquareMatrix<Rational> a(stages, std::vector<Rational>(stages));
  for (std::size_t i = 0; i < tableau.a.size(); ++i)
    for (std::size_t j = 0; j < tableau.a[i].size(); ++j) a[i][j] = value_of(tableau.a[i][j], parameters);
  SquareMatrix<Rational> b = a;
  for (auto& row : b)
    for (std::size_t j = 0; j < stages; ++j) row[j] -= value_of(tableau.b[j], parameters);
  return stability_function(reciprocal_characteristic(b), reciprocal_characteristic(a));
}

std::optional<StabilityFunction> stability_function(const Amplification& damped) {
  if (damped.matrix.size() != 2) return std::nullopt;
  // Drag alone: the velocity is multiplied by R(-d).
  const Fraction formula = damped.matrix[1][1]
                               .substitute(kStiffness, Fraction())
                               .substitute(kDamping, -Fraction::letter(kStiffness));
  StabilityFunction r = over_field(formula, damped.letters, damped.algebraic);
  const Fraction y = Fraction::letter(kStiffness), d = Fraction::letter(kDamping);
  const SquareMatrix<Fraction> flow{{0, 1}, {-y, -d}};
  if (reduced(product(in_matrix(r.formula.denominator(), flow), damped.matrix), damped.algebraic) !=
      reduced(in_matrix(r.formula.numerator(), flow), damped.algebraic))
    return std::nullopt;
  return r;
}

std::optional<StabilityFunction> stability_function(const Program& program, const Values& given) {
  const Values parameters = parameter_values(program, given);
  Values numbers = parameters;
  for (const Approximation& a : program.approximations) numbers[a.name] = a.value;
  if (program.tableau && is_rational(*program.tableau, numbers))
    return stability_function(*program.tableau, numbers);
  return stability_function(amplification(program, parameters, Damping::viscous));
}

bool is_hurwitz(const Univariate<Algebraic>& p) {
  if (p.degree() < 1) return !p.is_zero();
  // Routh's array: the rows of every second coefficient, each next one without its leading term.
  std::vector<Algebraic> above, below;
  const int sign = p.leading().sign();
  for (int k = p.degree(); k >= 0; --k)
    ((p.degree() - k) % 2 == 0 ? above : below).push_back(sign > 0 ? p[k] : -p[k]);
  for (int row = 0; row < p.degree(); ++row) {
    if (below.empty() || below[0].sign() <= 0) return false;
    std::vector<Algebraic> next;
    for (std::size_t k = 1; k < above.size(); ++k)
      next.push_back(above[k] - (k < below.size() ? above[0] / below[0] * below[k] : Algebraic(0)));
    above = std::exchange(below, std::move(next));
  }
  return true;
}

StabilityProperties stability_properties(const StabilityFunction& r) {
  StabilityProperties result;
  result.poles_right = is_hurwitz(mirrored(r.denominator));
  result.difference = squared_size(r.denominator) - squared_size(r.numerator);
  result.imaginary_axis = true;
  if (!result.difference.is_zero()) {
    std::vector<RealRoot> roots;
    for (const RootOver& root : positive_roots({in_square(result.difference)}, r.generator))
      roots.push_back(root.root);
    for (const Rational& y : samples_between(roots)) {
      if (result.difference.at(y * y).sign() >= 0) continue;
      result.imaginary_axis = false;
      result.violated_at = y;
      break;
    }
  }
  result.a_stable = result.poles_right && result.imaginary_axis;
  result.l_stable = result.a_stable && r.size_at_infinity() == Algebraic(0);
  const Fraction size = r.formula.substitute(kStiffness, -Fraction::letter(kStiffness));
  result.real_axis = bounded_windows({{size}}, kStiffness, r.algebraic);
  return result;
}

}  // namespace shortfall
