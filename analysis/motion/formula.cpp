// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/formula.hpp"

#include <algorithm>
#include <charconv>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

using Op = Expression::Op;

namespace {

/// A scalar has `factor`; a vector has `motion`, one entry a column.
struct FormulaValue {
  Sequence factor;
  Motion motion;
  bool is_vector() const { return !motion.empty(); }
};

/// k and m of an exponent k n + m with whole numbers k and m.
struct Exponent {
  std::int64_t count = 0;
  std::int64_t constant = 0;
};

class Evaluation {
 public:
  Evaluation(const FormulaScalars& scalars, int degree, ExtraLetters* extras = nullptr)
      : scalars_(scalars), columns_(degree + 3), extras_(extras) {}

  Motion motion(const Expr& e) const { return widened(of(e), e).motion; }
  /// What was divided by so far, without the power r^n in it.
  const std::vector<Fraction>& divisors() const { return divisors_; }

  FormulaValue of(const Expr& e) const {
    switch (e->op) {
      case Op::number:
        return {Sequence(e->value), {}};
      case Op::name:
        return of_name(e);
      case Op::negate:
        return scaled(of(e->operands[0]), Sequence(-1));
      case Op::add:
        return sum(e, Sequence(1));
      case Op::subtract:
        return sum(e, Sequence(-1));
      case Op::multiply:
        return product(e);
      case Op::divide:
        return scaled(of(e->operands[0]), reciprocal(e->operands[1]));
      case Op::power:
        return {power(e), {}};
      case Op::call:
        return {function(e), {}};
      case Op::force:
      case Op::sum:
        break;
    }
    throw Unable("a formula is made of numbers, names and + - * / ^; found '" + print(e) + "'");
  }

 private:
  Sequence function(const Expr& e) const {
    const auto argument = [&](const Expr& o) {
      const Sequence value = of(o).factor;
      if (!value.is_polynomial()) throw Unable("the value in '" + print(e) + "' depends on n");
      return value.polynomial();
    };
    if (!extras_) throw Unable("a formula of this kind calls no function; found '" + print(e) + "'");
    const Fraction a = argument(e->operands[0]);
    return extras_->function(*function_named(e->name), a,
                             e->operands.size() > 1 ? argument(e->operands[1]) : a);
  }

  FormulaValue of_name(const Expr& e) const {
    if (const auto found = scalars_.find(e->name); found != scalars_.end())
      return {Sequence(found->second), {}};
    FormulaValue value;
    value.motion.resize(columns_);
    value.motion[column(e->name)] = Sequence(1);
    return value;
  }

  int column(const std::string& name) const {
    if (name == "x0") return 0;
    if (name == "v0") return 1;
    if (name == "a") return 2;
    int d = -1;
    if (name.starts_with('f')) std::from_chars(name.data() + 1, name.data() + name.size(), d);
    if (d < 0 || d + 2 >= columns_) throw Error("the formula has an unknown name '" + name + "'");
    return d + 2;
  }

  /// As a vector; the number 0 is one as well.
  FormulaValue widened(FormulaValue value, const Expr& e) const {
    if (value.is_vector()) return value;
    if (!value.factor.is_zero()) throw Error("'" + print(e) + "' is no vector");
    value.motion.resize(columns_);
    return value;
  }

  static FormulaValue scaled(FormulaValue value, const Sequence& factor) {
    value.factor = value.factor * factor;
    for (Sequence& entry : value.motion) entry = entry * factor;
    return value;
  }

  FormulaValue sum(const Expr& e, const Sequence& sign) const {
    FormulaValue left = of(e->operands[0]);
    FormulaValue right = scaled(of(e->operands[1]), sign);
    if (!left.is_vector() && !right.is_vector()) return {left.factor + right.factor, {}};
    left = widened(std::move(left), e->operands[0]);
    right = widened(std::move(right), e->operands[1]);
    for (int i = 0; i < columns_; ++i) left.motion[i] += right.motion[i];
    return left;
  }

  FormulaValue product(const Expr& e) const {
    const FormulaValue left = of(e->operands[0]);
    const FormulaValue right = of(e->operands[1]);
    if (left.is_vector() && right.is_vector()) throw Error("'" + print(e) + "' multiplies two vectors");
    return left.is_vector() ? scaled(left, right.factor) : scaled(right, left.factor);
  }

  Sequence reciprocal(const Expr& e) const {
    const Sequence divisor = of(e).factor;
    if (divisor.is_zero()) throw Undefined("the formula divides by '" + print(e) + "', which is zero");
    if (divisor.terms().size() != 1)
      throw Unable("the formula divides by '" + print(e) + "', a sum of different powers");
    const Sequence::Term& term = divisor.terms().front();
    divisors_.push_back(term.coefficient);
    return Sequence(Fraction(1) / term.base, Fraction(1) / term.coefficient);
  }

  Sequence power(const Expr& e) const {
    const Exponent exponent = exponent_of(e->operands[1]);
    const Expr& base = e->operands[0];
    Sequence result(1);
    if (exponent.constant != 0) {
      const Sequence factor = exponent.constant < 0 ? reciprocal(base) : of(base).factor;
      for (std::int64_t k = 0; k < std::abs(exponent.constant); ++k) result = result * factor;
    }
    if (exponent.count == 0) return result;
    const Sequence value = of(base).factor;
    if (value.is_zero()) throw Undefined("the formula has a power of '" + print(base) + "', which is zero");
    if (!value.is_polynomial() || value.polynomial().contains(kCount))
      throw Unable("the base of '" + print(e) + "' depends on n");
    return result * Sequence(value.polynomial().pow(static_cast<int>(exponent.count)), 1);
  }

  Exponent exponent_of(const Expr& e) const {
    const Unable refusal("the exponent '" + print(e) +
                         "' is not of the form k*n + m with whole numbers k and m of at most 1000");
    const Sequence value = of(e).factor;
    if (!value.is_polynomial() || !value.polynomial().is_polynomial()) throw refusal;
    Exponent exponent;
    const Polynomial polynomial = value.polynomial().numerator();
    if (polynomial.total_degree() > 1 || polynomial.degree(kCount) < polynomial.total_degree()) throw refusal;
    const auto whole = [&](const Polynomial& p, std::int64_t& k) {
      if (!p.constant().fits_int64(k) || k < -1000 || k > 1000) throw refusal;
    };
    whole(polynomial.coefficient(kCount, 1), exponent.count);
    whole(polynomial.coefficient(kCount, 0), exponent.constant);
    return exponent;
  }

  const FormulaScalars& scalars_;
  int columns_;
  ExtraLetters* extras_;
  mutable std::vector<Fraction> divisors_;
};

/// The whole n >= 0 at which a polynomial that is not 0 vanishes for all values of its other letters.
std::vector<Rational> whole_zeros(const Polynomial& p) {
  Polynomial of_count;
  for (int number = 3; of_count.is_zero(); number += 2) {  // zero by chance: other numbers
    of_count = p;
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (letter != kCount) of_count = of_count.substitute(letter, Rational(number + letter, 2 + letter));
  }
  std::vector<Rational> zeros;
  for (const RealRoot& r : real_roots(univariate(of_count, kCount)))
    if (r.is_rational() && r.rational().is_integer() && r.rational().sign() >= 0 &&
        p.substitute(kCount, r.rational()).is_zero())
      zeros.push_back(r.rational());
  return zeros;
}

}  // namespace

FormulaScalars formula_scalars(const Program& program, const Values& given, ExtraLetters* extras) {
  FormulaScalars scalars;
  const Tape tape = lower(program, given);
  for (std::size_t i = 0; i < tape.parameters.size(); ++i) {
    const Tape::ParameterSlot& slot = tape.parameters[i];
    if (slot.fixed)
      scalars[slot.name] = *slot.fixed;
    else if (slot.derived)
      scalars[slot.name] = Evaluation(scalars, 0).of(program.parameters[i].fallback).factor.polynomial();
    else
      scalars[slot.name] = Fraction::letter(kFirstParameter + static_cast<Letter>(i));
  }
  for (const Approximation& a : program.approximations) scalars[a.name] = a.value;
  if (extras)
    for (const Root& r : program.roots) scalars[r.name] = extras->root(*r.value, r.name);
  const Fraction n = Fraction::letter(kCount);
  const Fraction h = Fraction::letter(kStepLetter);
  scalars.insert({{"n", n}, {"h", h}, {"t", n * h}});
  return scalars;
}

Motion evaluated(const Expr& formula, const FormulaScalars& scalars, int degree, ExtraLetters* extras) {
  return Evaluation(scalars, degree, extras).motion(formula);
}

FormulaGaps formula_gaps(const Expr& formula, const FormulaScalars& scalars, int degree,
                         ExtraLetters* extras) {
  const Evaluation evaluation(scalars, degree, extras);
  evaluation.motion(formula);
  FormulaGaps gaps;
  for (const Fraction& divisor : evaluation.divisors()) {
    const Polynomial& p = divisor.numerator();
    for (const Rational& n : whole_zeros(p))
      if (std::ranges::find(gaps.counts, n) == gaps.counts.end()) gaps.counts.push_back(n);
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (letter != kCount && letter != kStepLetter && p.degree(letter) > 0) gaps.of_letters = true;
  }
  std::ranges::sort(gaps.counts);
  return gaps;
}

Fraction scalar_value(const Expr& formula, const FormulaScalars& scalars, ExtraLetters* extras) {
  // Formulas are vectors: the coefficient of x0 is the number.
  const Motion motion = evaluated(binary(Expression::Op::multiply, formula, name("x0")), scalars, 0, extras);
  if (!motion[0].is_polynomial()) throw Unable("the value of '" + print(formula) + "' depends on n");
  return motion[0].polynomial();
}

}  // namespace shortfall
