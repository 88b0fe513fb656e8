// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/formula_text.hpp"

#include <algorithm>

#include "analysis/program/token_reader.hpp"

namespace shortfall {

namespace {

Expr powered(const std::string& letter, int exponent) {
  return exponent == 0 ? number(1) : power(letter_expression(letter), exponent);
}

/// |coefficient| * parameters * vector * h^i * n^j, with n h gathered into t when asked.
Expr term(const Polynomial::Term& t, const Expr& vector, const Wording& w) {
  Expr e = number(t.coefficient.abs());
  for (Letter letter = kStiffness; letter < static_cast<int>(w.letters.size()); ++letter)
    e = e * powered(w.letters[letter], t.monomial.exponent(letter));
  // Results read "1/2 a h t"; lines with a running index read "h v_k".
  if (vector && w.gather_time) e = e * vector;
  const int n = t.monomial.exponent(kCount);
  const int h = t.monomial.exponent(kStepLetter);
  if (w.gather_time && n > 0) {
    if (h > n) e = e * powered("h", h - n);
    e = e * powered("t", n);
    return h < n ? e / powered("h", n - h) : e;
  }
  e = e * powered("h", h);
  if (vector && !w.gather_time) e = e * vector;
  e = e * powered(w.count, n);
  return e * powered(w.letters[kTimeLetter], t.monomial.exponent(kTimeLetter));
}

Expr appended(Expr total, Expr more, bool negative) {
  if (!total) return negative ? negate(std::move(more)) : more;
  return negative ? std::move(total) - std::move(more) : std::move(total) + std::move(more);
}

Expr written_out(const Polynomial& p, const Expr& vector, const Wording& w, Expr total = nullptr) {
  const auto& terms = p.terms();
  // 1 - h^2 k/2 rather than -h^2 k/2 + 1.
  const bool backwards = !vector && !total && terms.size() > 1 && terms.front().coefficient.sign() < 0 &&
                         terms.back().coefficient.sign() > 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Polynomial::Term& t = backwards ? terms[terms.size() - 1 - i] : terms[i];
    total = appended(std::move(total), term(t, vector, w), t.coefficient.sign() < 0);
  }
  return total;
}

/// Whether the first sign of a quotient should be pulled out in front.
bool leads_with_minus(const Polynomial& p) {
  return !p.is_zero() && p.terms().front().coefficient.sign() < 0;
}

/// A factor without denominators, 2 rho - 1 and not rho - 1/2; what it was divided by goes to the constant.
Polynomial whole(const Polynomial& p, int multiplicity, Rational& constant) {
  Rational common = 1;  // the least common denominator: each step adds what the next coefficient still lacks
  for (const Polynomial::Term& t : p.terms()) common *= (common * t.coefficient).denominator();
  constant = constant / common.pow(multiplicity);
  return p * Polynomial(common);
}

/// constant * factor^m * ..., the shape in which a denominator and its numerator are read most easily; the
/// constant is multiplied to the one given.
Expr factored(const Polynomial& p, const Wording& w, Rational& constant) {
  const Factorization f = factor(p);
  Rational own = f.constant;
  Expr powers = number(1);
  for (const auto& [base, multiplicity] : f.factors)
    powers = powers * power(written_out(whole(base, multiplicity, own), nullptr, w), multiplicity);
  constant *= own;
  return powers;
}

/// n h gathered into t in a rational function whose powers of h suffice; then t stands in the letter of time.
Fraction gathered(const Fraction& f, const Wording& w) {
  if (!w.gather_time || !f.contains(kCount)) return f;
  return f.substitute(kCount, Fraction::letter(kTimeLetter) / Fraction::letter(kStepLetter));
}

Expr times_power(const Expr& e, const Fraction& base, const Wording& w) {
  if (base == Fraction(1)) return e;
  return e * binary(Expression::Op::power, formula(base, w), name(w.count));
}

void append(Expr& total, const Fraction& coefficient, const Expr& vector, const Fraction& base,
            const Wording& w) {
  const bool plain = base == Fraction(1);
  if (coefficient.is_polynomial() && (plain || coefficient.numerator().terms().size() == 1)) {
    for (const Polynomial::Term& t : coefficient.numerator().terms())
      total = appended(std::move(total), times_power(term(t, vector, w), base, w), t.coefficient.sign() < 0);
    return;
  }
  const Fraction inside = gathered(coefficient, w);
  const bool negative = leads_with_minus(inside.numerator());
  Expr factor = formula(negative ? -inside : inside, w);
  if (vector) factor = chained(factor, vector);
  total = appended(std::move(total), times_power(factor, base, w), negative);
}

}  // namespace

Expr letter_expression(const std::string& letter) {
  if (letter.find('(') == std::string::npos) return name(letter);
  const Source source("a letter", letter);
  int line = 1;
  return TokenReader(source, tokens(source, line, 0)).expression();
}

std::string unused_name(const std::string& wanted, const std::vector<std::string>& letters) {
  std::string name = wanted;
  for (int i = 0; std::ranges::find(letters, name) != letters.end(); ++i) name = wanted + std::to_string(i);
  return name;
}

std::string column_name(int column, int degree) {
  if (column == 0) return "x0";
  if (column == 1) return "v0";
  return degree == 0 ? "a" : "f" + std::to_string(column - 2);
}

Expr formula(const Fraction& f, const Wording& w) {
  if (f.is_zero()) return number(0);
  if (f.is_polynomial()) return written_out(f.numerator(), nullptr, w);
  const Fraction inside = gathered(f, w);
  if (inside.is_polynomial()) return written_out(inside.numerator(), nullptr, w);
  // 4*(C - 1)/(h*(3*C - 5)), and not 4/3*(C - 1)/(1/3*h*(3*C - 5)): one constant, in front.
  Rational above = 1, below = 1;
  const Expr numerator = factored(inside.numerator(), w, above);
  const Expr denominator = factored(inside.denominator(), w, below);
  return chained(number(above / below), numerator) / denominator;
}

Expr joined(const Expr& total, const Expr& part) {
  if (is_number(part, 0)) return total;
  if (is_number(total, 0)) return part;
  if (part->op == Expression::Op::add) return joined(joined(total, part->operands[0]), part->operands[1]);
  if (part->op == Expression::Op::subtract) return joined(total, part->operands[0]) - part->operands[1];
  return total + part;
}

Expr chained(const Expr& product, const Expr& factor) {
  if (factor->op == Expression::Op::multiply)
    return chained(chained(product, factor->operands[0]), factor->operands[1]);
  if (factor->op == Expression::Op::divide)
    return chained(product, factor->operands[0]) / factor->operands[1];
  return product * factor;
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
