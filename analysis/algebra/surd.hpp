// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <string>
#include <utility>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// p + q sqrt(d): an exact real number of a real quadratic field, such as a launch speed sqrt(2 g H).
///
/// Invariant: d >= 0; d is 0 and q is 0 when the number is rational (a square d is taken out of the root).
/// Two operands must share d up to a rational square, or one of them be rational; comparisons take any two.
class Surd {
 public:
  Surd() = default;
  Surd(Rational p) : p_(std::move(p)) {}
  template <std::integral I>
  Surd(I value) : p_(value) {}
  /// throws  Undefined  when d is negative
  Surd(Rational p, Rational q, Rational d);
  /// The square root of a non-negative rational.
  static Surd sqrt(const Rational& d) { return Surd(0, 1, d); }

  const Rational& rational_part() const& { return p_; }
  const Rational& root_part() const& { return q_; }
  const Rational& radicand() const& { return d_; }
  Rational rational_part() && { return std::move(p_); }
  Rational root_part() && { return std::move(q_); }
  Rational radicand() && { return std::move(d_); }
  bool is_rational() const { return q_.is_zero(); }
  bool is_zero() const { return p_.is_zero() && q_.is_zero(); }
  int sign() const;  ///< exact

  Surd operator-() const;
  Surd& operator+=(const Surd&);  ///< throws Unable when the two radicands differ
  Surd& operator-=(const Surd&);
  Surd& operator*=(const Surd&);
  Surd& operator/=(const Surd&);  ///< throws Undefined on division by zero
  friend Surd operator+(Surd a, const Surd& b) {
    a += b;
    return a;
  }
  friend Surd operator-(Surd a, const Surd& b) {
    a -= b;
    return a;
  }
  friend Surd operator*(Surd a, const Surd& b) {
    a *= b;
    return a;
  }
  friend Surd operator/(Surd a, const Surd& b) {
    a /= b;
    return a;
  }
  bool operator==(const Surd& other) const { return std::is_eq(*this <=> other); }
  std::strong_ordering operator<=>(const Surd& other) const;
  Surd abs() const { return sign() < 0 ? -*this : *this; }

  Rational floor() const;  ///< exact
  /// Nearest binary64 / binary32, ties to even.
  double to_double() const;
  float to_float() const;
  /// A rational within 10^-digits relative (10^-digits absolute for zero) of the number.
  Rational approximation(int digits) const;
  std::string decimal(int places) const;      ///< correctly rounded
  std::string significant(int digits) const;  ///< correctly rounded
  /// "1/2 + 3/4*sqrt(5)".
  std::string str() const;

 private:
  void settle();
  Rational p_;
  Rational q_;
  Rational d_;
};

}  // namespace shortfall
