// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <memory>

#include "analysis/stability/algebraic_letter.hpp"

namespace shortfall {

/// A number of the field K(s) that a real root s of a polynomial over K generates, K = Q(r) itself a field of
/// real algebraic numbers: exact and ordered.
///
/// Invariant: a polynomial in s over K, of lower degree than the modulus was when the number was made. The
/// modulus may be reducible; where a number turns out to share a factor with it, a factor that has the root s
/// takes its place. Elements of K belong to every field; two others must share their generator.
///
/// source  Della Dora, Dicrescenzo & Duval (1985), About a new method for computing in algebraic number
/// fields
class AlgebraicOver {
 public:
  /// s, and what is known of it so far.
  struct Extension {
    Algebraic::Generator base;      ///< r; none when K is Q
    RealRoot root;                  ///< s, as a number over Q
    Univariate<Algebraic> modulus;  ///< s is its only root in the root's interval
  };
  using Generator = std::shared_ptr<Extension>;

  AlgebraicOver() = default;
  AlgebraicOver(const Algebraic& value) : value_({value}) {}
  template <std::integral I>
  AlgebraicOver(I value) : AlgebraicOver(Algebraic(value)) {}
  /// p(s).
  AlgebraicOver(const Univariate<Algebraic>& p, Generator s);

  bool is_zero() const;  ///< exact
  int sign() const;      ///< exact: -1, 0 or 1
  AlgebraicOver abs() const { return sign() < 0 ? -*this : *this; }
  bool is_rational() const { return value_.is_zero() || (value_.degree() == 0 && value_[0].is_rational()); }
  Rational rational() const { return value_.is_zero() ? Rational() : value_[0].rational(); }

  AlgebraicOver operator-() const;
  AlgebraicOver& operator+=(const AlgebraicOver&);
  AlgebraicOver& operator-=(const AlgebraicOver& other) { return *this += -other; }
  AlgebraicOver& operator*=(const AlgebraicOver&);
  AlgebraicOver& operator/=(const AlgebraicOver&);  ///< throws Undefined on division by zero
  friend AlgebraicOver operator+(AlgebraicOver a, const AlgebraicOver& b) { return a += b; }
  friend AlgebraicOver operator-(AlgebraicOver a, const AlgebraicOver& b) { return a -= b; }
  friend AlgebraicOver operator*(AlgebraicOver a, const AlgebraicOver& b) { return a *= b; }
  friend AlgebraicOver operator/(AlgebraicOver a, const AlgebraicOver& b) { return a /= b; }
  bool operator==(const AlgebraicOver& other) const { return (*this - other).is_zero(); }
  bool operator<(const AlgebraicOver& other) const { return (*this - other).sign() < 0; }

 private:
  void join(const AlgebraicOver& other);
  void reduce();
  /// Its sign where intervals of this width for r and s show it; 0 where they do not.
  int visible_sign(const Rational& width) const;
  Generator generator_;  ///< none for a number of K
  Univariate<Algebraic> value_;
};

}  // namespace shortfall
