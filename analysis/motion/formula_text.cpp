// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

Expr powered(const std::string& letter, int exponent) {
  return exponent == 0 ? number(1) : power(name(letter), exponent);
}

/// |coefficient| * parameters * vector * h^i * n^j, with n h gathered into t when asked.
Expr term(const Polynomial::Term& t, const Expr& vector, const Wording& w) {
  Expr e = number(t.coefficient.abs());
  for (Letter letter = kStiffness; letter < static_cast<int>(w.letters.size()); ++letter)
    e = e * powered(w.letters[letter], t.monomial.exponent(letter));
  if (vector) e = e * vector;
  const int n = t.monomial.exponent(kCount);
  const int h = t.monomial.exponent(kStepLetter);
  if (w.gather_time && n > 0) {
    if (h > n) e = e * powered("h", h - n);
    e = e * powered("t", n);
    return h < n ? e / powered("h", n - h) : e;
  }
  e = e * powered("h", h) * powered(w.count, n);
  return e * powered(w.letters[kTimeLetter], t.monomial.exponent(kTimeLetter));
}

Expr appended(Expr total, Expr more, bool negative) {
  if (!total) return negative ? negate(std::move(more)) : more;
  return negative ? std::move(total) - std::move(more) : std::move(total) + std::move(more);
}

Expr written_out(const Polynomial& p, const Expr& vector, const Wording& w, Expr total = nullptr) {
  for (const Polynomial::Term& t : p.terms())
    total = appended(std::move(total), term(t, vector, w), t.coefficient.sign() < 0);
  return total;
}

/// Whether the first sign of a quotient should be pulled out in front.
bool leads_with_minus(const Polynomial& p) { return !p.is_zero() && p.terms().front().coefficient.sign() < 0; }

Expr times_power(const Expr& e, const Fraction& base, const Wording& w) {
  if (base == Fraction(1)) return e;
  return e * binary(Expression::Op::power, formula(base, w), name(w.count));
}

void append(Expr& total, const Fraction& coefficient, const Expr& vector, const Fraction& base, const Wording& w) {
  const bool plain = base == Fraction(1);
  if (coefficient.is_polynomial() && (plain || coefficient.numerator().terms().size() == 1)) {
    for (const Polynomial::Term& t : coefficient.numerator().terms())
      total = appended(std::move(total), times_power(term(t, vector, w), base, w), t.coefficient.sign() < 0);
    return;
  }
  const bool negative = leads_with_minus(coefficient.numerator());
  Expr factor = formula(negative ? -coefficient : coefficient, w);
  if (vector) factor = factor * vector;
  total = appended(std::move(total), times_power(factor, base, w), negative);
}

}  // namespace

std::string column_name(int column, int degree) {
  if (column == 0) return "x0";
  if (column == 1) return "v0";
  return degree == 0 ? "a" : "f" + std::to_string(column - 2);
}

Expr formula(const Fraction& f, const Wording& w) {
  if (f.is_zero()) return number(0);
  Expr top = written_out(f.numerator(), nullptr, w);
  return f.is_polynomial() ? top : top / written_out(f.denominator(), nullptr, w);
}

Expr formula(const Fraction& coefficient, const Expr& vector, const Wording& w) {
  Expr total;
  if (!coefficient.is_zero()) append(total, coefficient, vector, 1, w);
  return total ? total : number(0);
}

Expr formula(const Motion& motion, int degree, const Wording& w) {
  Expr total;
  for (std::size_t column = 0; column < motion.size(); ++column)
    for (const Sequence::Term& t : motion[column].terms())
      append(total, t.coefficient, name(column_name(static_cast<int>(column), degree)), t.base, w);
  return total ? total : number(0);
}

}  // namespace shortfall
