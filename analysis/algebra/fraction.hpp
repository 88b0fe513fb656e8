// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/number_field.hpp"
#include "analysis/algebra/polynomial.hpp"

namespace shortfall {

/// A rational function: a quotient of two polynomials over the rationals.
///
/// Invariant: in lowest terms, denominator monic (leading coefficient 1); so equality is structural. While
/// the denominator is 1 no gcd is computed, and nothing is stored for it. Within a NumberField its generators
/// are numbers: reduced, and in no denominator.
class Fraction {
 public:
  Fraction() = default;
  Fraction(Polynomial numerator) : numerator_(std::move(numerator)) { settle(); }
  Fraction(Rational constant) : Fraction(Polynomial(std::move(constant))) {}
  template <std::integral I>
  Fraction(I constant) : Fraction(Rational(constant)) {}
  /// throws  Undefined  when the denominator is zero
  Fraction(Polynomial numerator, Polynomial denominator);
  static Fraction letter(Letter letter, int exponent = 1);  ///< a negative exponent is allowed

  const Polynomial& numerator() const& { return numerator_; }
  const Polynomial& denominator() const& { return is_polynomial() ? one() : denominator_; }
  Polynomial numerator() && { return std::move(numerator_); }
  Polynomial denominator() && {
    if (is_polynomial()) return one();
    return std::move(denominator_);
  }
  bool is_zero() const { return numerator_.is_zero(); }
  bool is_one() const { return is_polynomial() && numerator_ == one(); }
  bool is_polynomial() const { return denominator_.is_zero(); }
  bool is_constant() const { return is_polynomial() && numerator_.is_constant(); }
  bool contains(Letter letter) const { return numerator_.contains(letter) || denominator_.contains(letter); }
  Rational constant() const { return numerator_.constant(); }  ///< meaningful when is_constant()

  Fraction operator-() const;
  Fraction& operator+=(const Fraction&);
  Fraction& operator-=(const Fraction&);
  Fraction& operator*=(const Fraction&);
  Fraction& operator/=(const Fraction&);  ///< throws Undefined on division by zero
  friend Fraction operator+(Fraction a, const Fraction& b) {
    a += b;
    return a;
  }
  friend Fraction operator-(Fraction a, const Fraction& b) {
    a -= b;
    return a;
  }
  friend Fraction operator*(Fraction a, const Fraction& b) {
    a *= b;
    return a;
  }
  friend Fraction operator/(Fraction a, const Fraction& b) {
    a /= b;
    return a;
  }
  bool operator==(const Fraction&) const = default;
  Fraction pow(int exponent) const;  ///< throws Undefined for a negative power of zero

  /// throws  Undefined  when the denominator vanishes there
  Fraction substitute(Letter letter, const Fraction& value) const;
  /// throws  Undefined  when the denominator vanishes there; Error when a letter has no value
  Rational evaluate(const std::map<Letter, Rational>& values) const;

  /// "(h + 1)/(h - 1)", letters named by the caller.
  std::string str(std::span<const std::string> names) const;

 private:
  void add(const Fraction&, bool negated);
  void reduce();
  void cancel();
  void make_monic();
  void settle() {
    if (NumberField::current()) settle_in_field();
  }
  void settle_in_field();
  void set_denominator(Polynomial);
  static const Polynomial& one();
  Polynomial numerator_;
  Polynomial denominator_;  ///< 0 stands for 1, the common case
};

}  // namespace shortfall
