// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <memory>

#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

/// A number of the field Q(r) that one real algebraic number r generates: an exact, ordered field.
///
/// Invariant: a polynomial in r of lower degree than r's own. Rational numbers belong to every field; two
/// others must share their generator.
class Algebraic {
 public:
  using Generator = std::shared_ptr<const RealRoot>;

  Algebraic() = default;
  Algebraic(const Rational& value) : value_({value}) {}
  template <std::integral I>
  Algebraic(I value) : Algebraic(Rational(value)) {}
  /// p(r).
  Algebraic(const Univariate<Rational>& p, Generator r);

  bool is_zero() const { return value_.is_zero(); }
  int sign() const;  ///< exact: -1, 0 or 1
  Algebraic abs() const { return sign() < 0 ? -*this : *this; }
  bool is_rational() const { return value_.degree() < 1; }
  Rational rational() const { return is_zero() ? Rational() : value_[0]; }  ///< meaningful when is_rational()
  const Univariate<Rational>& polynomial() const {
    return value_;
  }  ///< p with p(r) its value, of lower degree than r

  double to_double() const;  ///< within a few units of the last place

  Algebraic operator-() const;
  Algebraic& operator+=(const Algebraic&);
  Algebraic& operator-=(const Algebraic&);
  Algebraic& operator*=(const Algebraic&);
  Algebraic& operator/=(const Algebraic&);  ///< throws Undefined on division by zero
  friend Algebraic operator+(Algebraic a, const Algebraic& b) { return a += b; }
  friend Algebraic operator-(Algebraic a, const Algebraic& b) { return a -= b; }
  friend Algebraic operator*(Algebraic a, const Algebraic& b) { return a *= b; }
  friend Algebraic operator/(Algebraic a, const Algebraic& b) { return a /= b; }
  bool operator==(const Algebraic& other) const { return value_ == other.value_; }
  bool operator<(const Algebraic& other) const { return (*this - other).sign() < 0; }

 private:
  void join(const Algebraic& other);
  void reduce();
  Generator generator_;  ///< none for a rational number
  Univariate<Rational> value_;
};

}  // namespace shortfall
