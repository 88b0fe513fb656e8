// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

/// A real number known to lie in an interval, midpoint plus or minus radius: what is computed with balls is
/// certain, only not sharp.
///
/// Invariant: the number that it stands for lies inside. A ball carries a working precision; a result has the
/// larger one of its operands. Whole numbers and binary fractions converted exactly have radius 0. Exponents
/// are of any size, so nothing overflows.
///
/// source  Johansson (2017), Arb: efficient arbitrary-precision midpoint-radius interval arithmetic, IEEE
/// Transactions on Computers 66
class Ball {
 public:
  Ball() : Ball(0, 2) {}
  /// throws  Error  when bits is not in 2..100,000,000
  Ball(const Rational& value, int bits);
  Ball(const Ball& other);
  Ball(Ball&& other) noexcept;
  Ball& operator=(const Ball& other);
  Ball& operator=(Ball&& other) noexcept;
  ~Ball();

  int bits() const { return bits_; }  ///< the working precision
  bool is_exact() const;              ///< radius 0
  bool is_zero() const;               ///< exactly 0
  bool contains_zero() const;
  bool is_finite() const;
  /// The sign of the number: -1, 0 or 1; unknown where the ball straddles 0.
  std::optional<int> sign() const;
  bool contains(const Rational& value) const;
  bool overlaps(const Ball& other) const;

  Ball operator-() const;
  Ball& operator+=(const Ball&);
  Ball& operator-=(const Ball&);
  Ball& operator*=(const Ball&);
  Ball& operator/=(const Ball&);  ///< by a ball that contains 0: an infinite one
  friend Ball operator+(Ball a, const Ball& b) { return a += b; }
  friend Ball operator-(Ball a, const Ball& b) { return a -= b; }
  friend Ball operator*(Ball a, const Ball& b) { return a *= b; }
  friend Ball operator/(Ball a, const Ball& b) { return a /= b; }
  /// this += a * b, rounded once.
  void add_product(const Ball& a, const Ball& b);

  friend Ball sqrt(const Ball&);  ///< not finite where the ball holds negative numbers
  friend Ball exp(const Ball&);
  friend Ball log(const Ball&);
  friend Ball sin(const Ball&);
  friend Ball cos(const Ball&);
  friend Ball sinh(const Ball&);
  friend Ball cosh(const Ball&);
  friend Ball abs(const Ball&);
  friend Ball pow(const Ball&, int exponent);
  /// The ball that holds all of both.
  friend Ball hull(const Ball&, const Ball&);

  /// The number rounded to so many significant digits, when the ball decides every one of them: the last is
  /// off by half a unit at most. "0" for exactly 0; in the form 1.25e-09 outside [1e-6, 1e15).
  ///
  /// throws  Unable  when the decimal exponent has more than 18 digits
  std::optional<std::string> significant(int digits) const;
  /// An upper bound of the radius with two digits: "3.1e-62"; "0" when the ball is exact.
  std::string radius() const;
  /// The midpoint in binary64, rounded.
  double to_double() const;
  /// The midpoint, an exact binary fraction.
  ///
  /// throws  Unable  when its exponent is beyond 2^20
  Rational midpoint() const;

 private:
  friend struct BallAccess;
  static constexpr std::size_t kSize = 48;  // of Arb's own structure
  alignas(8) std::byte storage_[kSize];
  int bits_;
};

/// An algebraic number.
Ball ball(const RealRoot& root, int bits);

}  // namespace shortfall
