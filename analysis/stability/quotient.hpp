// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <utility>

#include "analysis/algebra/univariate.hpp"

namespace shortfall {

/// A rational function of one unknown over a field F: a quotient of two polynomials, itself a field.
///
/// Invariant: in lowest terms, denominator monic; so equality is structural.
template <class F>
class Quotient {
 public:
  Quotient() : Quotient(0) {}
  template <std::integral I>
  Quotient(I value) : Quotient(F(value)) {}
  Quotient(F value) : numerator_({std::move(value)}), denominator_({F(1)}) {}
  Quotient(Univariate<F> numerator) : numerator_(std::move(numerator)), denominator_({F(1)}) {}
  /// throws  Undefined  when the denominator is zero
  Quotient(Univariate<F> numerator, Univariate<F> denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (denominator_.is_zero()) throw Undefined("division by zero");
    reduce();
  }

  const Univariate<F>& numerator() const { return numerator_; }
  const Univariate<F>& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.is_zero(); }

  Quotient operator-() const {
    Quotient result = *this;
    result.numerator_ = -result.numerator_;
    return result;
  }
  friend Quotient operator+(const Quotient& a, const Quotient& b) {
    if (a.denominator_ == b.denominator_) return {a.numerator_ + b.numerator_, a.denominator_};
    return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_, a.denominator_ * b.denominator_};
  }
  friend Quotient operator-(const Quotient& a, const Quotient& b) { return a + -b; }
  friend Quotient operator*(const Quotient& a, const Quotient& b) {
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  /// throws  Undefined  on division by zero
  friend Quotient operator/(const Quotient& a, const Quotient& b) {
    return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
  }
  Quotient& operator+=(const Quotient& b) { return *this = *this + b; }
  Quotient& operator-=(const Quotient& b) { return *this = *this - b; }
  Quotient& operator*=(const Quotient& b) { return *this = *this * b; }
  Quotient& operator/=(const Quotient& b) { return *this = *this / b; }
  bool operator==(const Quotient&) const = default;

 private:
  void reduce() {
    if (denominator_.degree() > 0) {
      const Univariate<F> common = gcd(numerator_, denominator_);
      if (common.degree() > 0) {
        numerator_ = divided(numerator_, common).first;
        denominator_ = divided(denominator_, common).first;
      }
    }
    if (denominator_.leading() == F(1)) return;
    const Univariate<F> scale({F(1) / denominator_.leading()});
    numerator_ = numerator_ * scale;
    denominator_ = denominator_ * scale;
  }
  Univariate<F> numerator_;
  Univariate<F> denominator_;
};

}  // namespace shortfall
