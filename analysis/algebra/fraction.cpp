// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/fraction.hpp"

#include <algorithm>
#include <utility>

#include "analysis/algebra/error.hpp"

namespace shortfall {
namespace {

/// Sum of coefficients[k] p^k q^(n-k) with n the highest power: the numerator over q^n after letter -> p/q.
Polynomial homogenized(const std::vector<Polynomial>& coefficients, const Polynomial& p,
                       const Polynomial& q) {
  Polynomial sum;
  Polynomial scale = 1;
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    if (k + 1 < coefficients.size()) scale *= q;
    sum = sum * p + coefficients[k] * scale;
  }
  return sum;
}

std::string factor_text(const Polynomial& p, std::span<const std::string> names) {
  const std::string text = p.str(names);
  return p.terms().size() > 1 ? "(" + text + ")" : text;
}

/// Whether the text of p may stand after a slash as it is: one letter, with its power.
bool is_power_of_letter(const Polynomial& p) {
  if (p.terms().size() != 1) return false;
  int letters = 0;
  for (Letter letter = 0; letter < kLetters; ++letter) letters += p.contains(letter);
  return letters == 1;
}

}  // namespace

const Polynomial& Fraction::one() {
  static const Polynomial one = 1;
  return one;
}

Fraction::Fraction(Polynomial numerator, Polynomial denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.is_zero()) throw Undefined("a fraction cannot have the denominator zero");
  reduce();
}

Fraction Fraction::letter(Letter letter, int exponent) {
  if (exponent >= 0) return Polynomial::letter(letter, exponent);
  Fraction result(1);
  result.denominator_ = Polynomial::letter(letter, -exponent);
  result.settle();
  return result;
}

/// Algebraic letters reduced, and out of the denominator.
void Fraction::settle_in_field() {
  const NumberField& field = *NumberField::current();
  if (is_polynomial()) {
    numerator_ = field.reduced(std::move(numerator_));
    return;
  }
  const Polynomial before = denominator_;
  field.settle(numerator_, denominator_);
  if (numerator_.is_zero())
    denominator_ = {};
  else if (denominator_ != before || !gcd(numerator_, denominator_).is_constant())
    cancel();
}

/// A denominator that is monic, hence 1 when it is constant.
void Fraction::set_denominator(Polynomial denominator) {
  denominator_ = denominator.is_constant() ? Polynomial() : std::move(denominator);
}

void Fraction::make_monic() {
  const Rational leading = denominator_.terms().front().coefficient;
  if (!leading.is_one()) {
    const Rational factor = 1 / leading;
    numerator_ *= factor;
    denominator_ *= factor;
  }
  if (denominator_.is_constant()) denominator_ = {};
}

/// Restores the invariant after a change of the numerator, or with any denominator but 0.
void Fraction::reduce() {
  if (denominator_.is_zero()) return;
  if (numerator_.is_zero()) {
    denominator_ = {};
    return;
  }
  cancel();
  settle();
}

void Fraction::cancel() {
  if (!denominator_.is_constant()) {
    Polynomial above, below;
    gcd(numerator_, denominator_, &above, &below);
    numerator_ = std::move(above);
    denominator_ = std::move(below);
  }
  make_monic();
}

Fraction Fraction::operator-() const {
  Fraction result;
  result.numerator_ = -numerator_;
  result.denominator_ = denominator_;
  return result;
}

void Fraction::add(const Fraction& other, bool negated) {
  const auto accumulate = [negated](Polynomial& sum, const Polynomial& p) {
    if (negated)
      sum -= p;
    else
      sum += p;
  };
  if (other.is_zero()) return;
  if (is_polynomial() && other.is_polynomial()) {
    accumulate(numerator_, other.numerator_);
    return;  // a sum of reduced polynomials is reduced
  }
  if (denominator_ == other.denominator_) {
    accumulate(numerator_, other.numerator_);
    reduce();
    return;
  }
  // Only the common part of the denominators can cancel again.
  Polynomial mine, theirs;
  Polynomial common = gcd(denominator(), other.denominator(), &mine, &theirs);
  Polynomial numerator = numerator_ * theirs;
  accumulate(numerator, other.numerator_ * mine);
  if (numerator.is_zero()) {
    *this = Fraction();
    return;
  }
  if (!common.is_constant()) {
    Polynomial above, below;
    gcd(numerator, common, &above, &below);
    numerator = std::move(above);
    common = std::move(below);
  }
  numerator_ = std::move(numerator);
  set_denominator(mine * theirs * common);
  settle();
}

Fraction& Fraction::operator+=(const Fraction& other) {
  if (this == &other) return *this *= Fraction(2);
  add(other, false);
  return *this;
}

Fraction& Fraction::operator-=(const Fraction& other) {
  if (this == &other) return *this = Fraction();
  add(other, true);
  return *this;
}

Fraction& Fraction::operator*=(const Fraction& other) {
  if (is_polynomial() && other.is_polynomial()) {
    numerator_ *= other.numerator_;
    settle();
    return *this;
  }
  if (is_zero() || other.is_zero()) return *this = Fraction();
  // Each numerator can cancel only against the other denominator; products of monic polynomials are monic.
  Polynomial my_above, my_below, their_above, their_below;
  gcd(numerator_, other.denominator(), &my_above, &their_below);
  gcd(other.numerator_, denominator(), &their_above, &my_below);
  numerator_ = my_above * their_above;
  set_denominator(my_below * their_below);
  settle();
  return *this;
}

Fraction& Fraction::operator/=(const Fraction& other) {
  if (other.is_zero()) throw Undefined("division of a fraction by zero");
  if (other.is_constant()) {
    numerator_ *= 1 / other.constant();
    return *this;
  }
  Fraction inverse;
  inverse.numerator_ = other.denominator();
  inverse.denominator_ = other.numerator_;
  inverse.make_monic();
  inverse.settle();
  return *this *= inverse;
}

Fraction Fraction::pow(int exponent) const {
  if (exponent < 0) {
    if (is_zero()) throw Undefined("zero has no negative power");
    return (Fraction(1) / *this).pow(-exponent);
  }
  Fraction result;
  result.numerator_ = numerator_.pow(exponent);
  if (!is_polynomial() && exponent > 0) result.denominator_ = denominator_.pow(exponent);
  result.settle();
  return result;
}

Fraction Fraction::substitute(Letter letter, const Fraction& value) const {
  if (!contains(letter)) return *this;
  const Undefined vanishes("the denominator of a fraction vanishes where a letter is replaced");
  if (value.is_polynomial()) {
    if (is_polynomial()) return numerator_.substitute(letter, value.numerator_);
    Polynomial below = denominator_.substitute(letter, value.numerator_);
    if (below.is_zero()) throw vanishes;
    return Fraction(numerator_.substitute(letter, value.numerator_), std::move(below));
  }
  const Polynomial& p = value.numerator_;
  const Polynomial& q = value.denominator_;
  Polynomial above = homogenized(numerator_.coefficients(letter), p, q);
  Polynomial below = homogenized(denominator().coefficients(letter), p, q);
  if (below.is_zero()) throw vanishes;
  const int surplus = denominator().degree(letter) - std::max(numerator_.degree(letter), 0);
  (surplus > 0 ? above : below) *= q.pow(std::abs(surplus));
  return Fraction(std::move(above), std::move(below));
}

Rational Fraction::evaluate(const std::map<Letter, Rational>& values) const {
  if (is_polynomial()) return numerator_.evaluate(values);
  const Rational below = denominator_.evaluate(values);
  if (below.is_zero()) throw Undefined("the denominator of a fraction vanishes at the values of its letters");
  return numerator_.evaluate(values) / below;
}

std::string Fraction::str(std::span<const std::string> names) const {
  if (is_polynomial()) return numerator_.str(names);
  const std::string below = denominator_.str(names);
  return factor_text(numerator_, names) + "/" +
         (is_power_of_letter(denominator_) ? below : "(" + below + ")");
}

}  // namespace shortfall
