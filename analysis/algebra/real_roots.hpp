// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/univariate.hpp"

namespace shortfall {

/// A real algebraic number: one root of an irreducible polynomial, told from the others by an interval.
///
/// Invariant: the polynomial is irreducible over the rationals, with coprime integer coefficients and a
/// positive leading one; low < root < high and no other root lies there, or low = root = high when the root
/// is rational.
class RealRoot {
 public:
  RealRoot(Rational value);
  /// throws  Error  when the polynomial has not exactly one root in the interval (low, high)
  RealRoot(const Univariate<Rational>& irreducible, Rational low, Rational high);

  const Univariate<Rational>& polynomial() const { return polynomial_; }
  int degree() const { return polynomial_.degree(); }
  bool is_rational() const { return degree() == 1; }
  Rational rational() const;  ///< meaningful when is_rational()
  /// The square, when that is rational.
  std::optional<Rational> rational_square() const;
  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }

  /// The same number in an interval no longer than `width`.
  RealRoot refined(const Rational& width) const;
  /// -1, 0 or 1 for this below, equal to or above the other.
  int compare(const RealRoot& other) const;
  int compare(const Rational& other) const;
  bool operator==(const RealRoot& other) const { return compare(other) == 0; }

  double to_double() const;
  std::string decimal(int places) const;      ///< correctly rounded
  std::string significant(int digits) const;  ///< correctly rounded
  /// Decimal digits after the point that give so many significant ones.
  int places(int significant_digits) const;

 private:
  void halve();
  Univariate<Rational> polynomial_;
  Rational low_;
  Rational high_;
};

/// The polynomial with coprime integer coefficients and positive leading coefficient that has the same roots.
Univariate<Rational> primitive(const Univariate<Rational>& p);

/// A polynomial that contains no letter but this one.
///
/// throws  Error  when it does
Univariate<Rational> univariate(const Polynomial& p, Letter letter);

/// All distinct real roots, in increasing order, in intervals that do not touch each other.
std::vector<RealRoot> real_roots(const Univariate<Rational>& p);
/// Those above 0, of all these polynomials together; their intervals do not touch 0 either.
std::vector<RealRoot> positive_roots(const std::vector<Univariate<Rational>>& polynomials);

/// The positive root of a positive number: its own polynomial and interval.
///
/// throws  Undefined  when it is not positive
RealRoot square_root(const RealRoot& square);
/// number * factor, for a factor > 0.
RealRoot scaled(const RealRoot& number, const Rational& factor);

/// The rational of smallest denominator (then smallest numerator) with low < r < high.
Rational simplest_between(const Rational& low, const Rational& high);

}  // namespace shortfall
