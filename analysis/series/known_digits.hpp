// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <utility>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A number known to some digits: a published decimal that stands for another number, or what was computed
/// from such. Holds as a field for series; "zero" means exactly 0, while `zero_as_known` means zero to the
/// digits known.
///
/// Invariant: the true number lies in the ball, as long as the decimals that it came from agree with the true
/// coefficients to their last digit.
class KnownDigits {
 public:
  static constexpr int kBits = 256;

  KnownDigits() : KnownDigits(0) {}
  template <std::integral I>
  KnownDigits(I value) : KnownDigits(Rational(value)) {}
  KnownDigits(const Rational& value) : ball_(value, kBits) {}
  explicit KnownDigits(Ball ball) : ball_(std::move(ball)) {}
  /// What a decimal can stand for: off by at most one unit of its last digit, "0.12" is 0.11 to 0.13.
  ///
  /// throws  BadInput  when the text is no decimal
  static KnownDigits printed(const std::string& decimal);

  bool is_zero() const { return ball_.is_zero(); }
  bool contains_zero() const { return ball_.contains_zero(); }
  const Ball& ball() const { return ball_; }
  /// Decimal digits after the point that are certain, at most 76: the radius is below 10^-digits.
  int digits() const;
  /// As many digits as are certain, 60 at most; "0" when there are none.
  std::string str() const;

  KnownDigits operator-() const { return KnownDigits(-ball_); }
  KnownDigits& operator+=(const KnownDigits& other) { return ball_ += other.ball_, *this; }
  KnownDigits& operator-=(const KnownDigits& other) { return ball_ -= other.ball_, *this; }
  KnownDigits& operator*=(const KnownDigits& other) { return ball_ *= other.ball_, *this; }
  KnownDigits& operator/=(const KnownDigits& other) { return ball_ /= other.ball_, *this; }
  friend KnownDigits operator+(KnownDigits a, const KnownDigits& b) { return a += b; }
  friend KnownDigits operator-(KnownDigits a, const KnownDigits& b) { return a -= b; }
  friend KnownDigits operator*(KnownDigits a, const KnownDigits& b) { return a *= b; }
  friend KnownDigits operator/(KnownDigits a, const KnownDigits& b) { return a /= b; }

 private:
  Ball ball_;
};

/// Zero, or zero as far as the digits tell.
template <class Field>
bool zero_as_known(const Field& value) {
  return value.is_zero();
}
inline bool zero_as_known(const KnownDigits& value) { return value.contains_zero(); }

}  // namespace shortfall
