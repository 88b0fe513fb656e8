// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_function.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/stability/amplification.hpp"

namespace shortfall {

namespace {

Rational value_of(const Expr& e, const Values& parameters) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t i) { return value_of(e->operands[i], parameters); };
  switch (e->op) {
    case Op::number:
      return e->value;
    case Op::negate:
      return -operand(0);
    case Op::add:
      return operand(0) + operand(1);
    case Op::subtract:
      return operand(0) - operand(1);
    case Op::multiply:
      return operand(0) * operand(1);
    case Op::divide:
      return operand(0) / operand(1);
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

StabilityFunction reduced(const Univariate<Rational>& p, const Univariate<Rational>& q) {
  const Univariate<Rational> common = gcd(p, q);
  Univariate<Rational> above = divided(p, common).first, below = divided(q, common).first;
  if (below[0].is_zero()) throw Undefined("the stability function has a pole at 0");
  const Univariate<Rational> scale({Rational(1) / below[0]});
  return {above * scale, below * scale};
}

/// p(M), entry by entry.
SquareMatrix<Fraction> in_matrix(const Univariate<Rational>& p, const SquareMatrix<Fraction>& m) {
  std::vector<Fraction> coefficients(p.coefficients().begin(), p.coefficients().end());
  return evaluated(Univariate<Fraction>(std::move(coefficients)), m);
}

/// Even and odd part of p(iy): p(iy) = even(y^2) + i y odd(y^2).
std::pair<Univariate<Rational>, Univariate<Rational>> on_imaginary_axis(const Univariate<Rational>& p) {
  std::vector<Rational> even, odd;
  for (int k = 0; k <= p.degree(); ++k) (k % 2 == 0 ? even : odd).push_back(k / 2 % 2 == 0 ? p[k] : -p[k]);
  return {even, odd};
}

/// |p(iy)|^2 as a polynomial in y^2.
Univariate<Rational> squared_size(const Univariate<Rational>& p) {
  const auto [even, odd] = on_imaginary_axis(p);
  return even * even + Univariate<Rational>({Rational(0), Rational(1)}) * odd * odd;
}

/// p(y^2).
Univariate<Rational> in_square(const Univariate<Rational>& p) {
  std::vector<Rational> result;
  for (const Rational& c : p.coefficients()) {
    if (!result.empty()) result.push_back(0);
    result.push_back(c);
  }
  return result;
}

/// p(-z).
Univariate<Rational> mirrored(const Univariate<Rational>& p) {
  std::vector<Rational> result = p.coefficients();
  for (std::size_t k = 1; k < result.size(); k += 2) result[k] = -result[k];
  return result;
}

}  // namespace

Rational StabilityFunction::at(const Rational& z) const { return numerator.at(z) / denominator.at(z); }

std::optional<Rational> StabilityFunction::size_at_infinity() const {
  if (numerator.degree() > denominator.degree()) return std::nullopt;
  if (numerator.degree() < denominator.degree()) return Rational(0);
  return (numerator.leading() / denominator.leading()).abs();
}

StabilityFunction stability_function(const Tableau& tableau, const Values& parameters) {
  const std::size_t stages = tableau.b.size();
  SquareMatrix<Rational> a(stages, std::vector<Rational>(stages));
  for (std::size_t i = 0; i < tableau.a.size(); ++i)
    for (std::size_t j = 0; j < tableau.a[i].size(); ++j) a[i][j] = value_of(tableau.a[i][j], parameters);
  SquareMatrix<Rational> b = a;
  for (auto& row : b)
    for (std::size_t j = 0; j < stages; ++j) row[j] -= value_of(tableau.b[j], parameters);
  return reduced(reciprocal_characteristic(b), reciprocal_characteristic(a));
}

std::optional<StabilityFunction> stability_function(const Program& program, const Values& given) {
  const Values parameters = parameter_values(program, given);
  if (program.tableau && is_rational(*program.tableau, parameters))
    return stability_function(*program.tableau, parameters);
  const Amplification a = amplification(program, parameters, Damping::viscous);
  if (a.matrix.size() != 2) return std::nullopt;
  // Drag alone: the velocity is multiplied by R(-d).
  const Fraction drag = a.matrix[1][1].substitute(kStiffness, Fraction());
  if (std::ranges::any_of(a.algebraic, [&](const AlgebraicLetter& l) { return drag.contains(l.letter); }))
    return std::nullopt;
  const auto p = mirrored(univariate(drag.numerator(), kDamping)),
             q = mirrored(univariate(drag.denominator(), kDamping));
  StabilityFunction r = reduced(p, q);
  const Fraction y = Fraction::letter(kStiffness), d = Fraction::letter(kDamping);
  const SquareMatrix<Fraction> flow{{0, 1}, {-y, -d}};
  if (reduced(product(in_matrix(r.denominator, flow), a.matrix), a.algebraic) != in_matrix(r.numerator, flow))
    return std::nullopt;
  return r;
}

bool is_hurwitz(const Univariate<Rational>& p) {
  if (p.degree() < 1) return !p.is_zero();
  // Routh's array: the rows of every second coefficient, each next one without its leading term.
  std::vector<Rational> above, below;
  const int sign = p.leading().sign();
  for (int k = p.degree(); k >= 0; --k)
    ((p.degree() - k) % 2 == 0 ? above : below).push_back(sign > 0 ? p[k] : -p[k]);
  for (int row = 0; row < p.degree(); ++row) {
    if (below.empty() || below[0].sign() <= 0) return false;
    std::vector<Rational> next;
    for (std::size_t k = 1; k < above.size(); ++k)
      next.push_back(above[k] - (k < below.size() ? above[0] / below[0] * below[k] : Rational(0)));
    above = std::exchange(below, std::move(next));
  }
  return true;
}

StabilityProperties stability_properties(const StabilityFunction& r) {
  StabilityProperties result;
  result.poles_right = is_hurwitz(mirrored(r.denominator));
  result.difference = squared_size(r.denominator) - squared_size(r.numerator);
  result.imaginary_axis = true;
  if (!result.difference.is_zero())
    for (const Rational& y : samples_between(positive_roots({in_square(result.difference)}))) {
      if (result.difference.at(y * y).sign() >= 0) continue;
      result.imaginary_axis = false;
      result.violated_at = y;
      break;
    }
  result.a_stable = result.poles_right && result.imaginary_axis;
  result.l_stable = result.a_stable && r.size_at_infinity() == Rational(0);
  const Fraction size(Polynomial::in(kStiffness, mirrored(r.numerator).coefficients()),
                      Polynomial::in(kStiffness, mirrored(r.denominator).coefficients()));
  result.real_axis = bounded_windows({{size}}, kStiffness);
  return result;
}

}  // namespace shortfall
