// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace shortfall {

/// A binary format of at most 16 bits, correctly rounded to nearest, ties to even, or toward zero.
///
/// A number is held in a binary64, which has more than twice the digits: sums and products are exact there or
/// so precise, and quotients so far from a tie, that rounding twice is rounding once (Figueroa 1995, When is
/// double rounding innocuous?). Subnormals are those of the format.
///
/// param   Precision  bits, the leading one included
/// param   Greatest   exponent of the largest numbers: they are below 2^(Greatest + 1)
template <int Precision, int Greatest, bool TowardZero = false>
class SmallFloat {
 public:
  static constexpr int kPrecision = Precision;
  static constexpr int kGreatest = Greatest;
  static constexpr int kLeastUnit = 2 - Greatest - Precision;  ///< subnormals are multiples of 2^kLeastUnit

  SmallFloat() = default;
  /// Rounds.
  explicit SmallFloat(double value) : value_(rounded(value)) {}

  double value() const { return value_; }

  SmallFloat operator-() const { return exactly(-value_); }
  friend SmallFloat operator+(SmallFloat a, SmallFloat b) { return sum(a.value_, b.value_); }
  friend SmallFloat operator-(SmallFloat a, SmallFloat b) { return sum(a.value_, -b.value_); }
  friend SmallFloat operator*(SmallFloat a, SmallFloat b) { return SmallFloat(a.value_ * b.value_); }
  friend SmallFloat operator/(SmallFloat a, SmallFloat b) {
    const double quotient = a.value_ / b.value_;
    if (!TowardZero || !std::isfinite(quotient) || quotient == 0) return SmallFloat(quotient);
    return SmallFloat(odd(quotient, std::fma(-quotient, b.value_, a.value_) * (b.value_ < 0 ? -1.0 : 1.0)));
  }
  friend bool operator==(SmallFloat a, SmallFloat b) { return a.value_ == b.value_; }
  friend bool operator<(SmallFloat a, SmallFloat b) { return a.value_ < b.value_; }

  /// a b + c, rounded once.
  friend SmallFloat fma(SmallFloat a, SmallFloat b, SmallFloat c) {
    return sum(a.value_ * b.value_, c.value_);  // the product is exact
  }
  friend SmallFloat sqrt(SmallFloat a) {
    const double root = std::sqrt(a.value_);
    if (!TowardZero || !std::isfinite(root)) return SmallFloat(root);
    return SmallFloat(odd(root, std::fma(-root, root, a.value_)));
  }
  /// Rounded from binary64, whose last digit is not always right: one in about 2^40 is rounded wrongly.
  friend SmallFloat exp(SmallFloat a) { return SmallFloat(std::exp(a.value_)); }
  friend SmallFloat log(SmallFloat a) { return SmallFloat(std::log(a.value_)); }
  friend SmallFloat pow(SmallFloat a, SmallFloat b) { return SmallFloat(std::pow(a.value_, b.value_)); }

 private:
  static SmallFloat exactly(double value) {
    SmallFloat result;
    result.value_ = value;
    return result;
  }

  /// The sum of two doubles, rounded once: what binary64 cannot hold only tells on which side of a tie it is.
  static SmallFloat sum(double a, double b) {
    const double s = a + b;
    if (!std::isfinite(s)) return SmallFloat(s);
    const double b_part = s - a;
    const double error = (a - (s - b_part)) + (b - b_part);
    return SmallFloat(odd(s, error));
  }

  /// A binary64 whose last bit is set when something was lost below it (rounding to odd).
  static double odd(double value, double error) {
    if (error == 0 || value == 0) return value;
    std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    if ((bits & 1) != 0) return value;
    // Even: the neighbour on the error's side is odd, and nearer to the truth than the other.
    return (error > 0) == (value > 0) ? std::bit_cast<double>(bits + 1) : std::bit_cast<double>(bits - 1);
  }

  static double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return value;
    int exponent = 0;
    std::frexp(value, &exponent);  // |value| in [2^(exponent - 1), 2^exponent)
    const int unit = std::max(exponent - Precision, kLeastUnit);
    const double scaled = std::ldexp(value, -unit);  // exact: below 2^Precision, or tiny
    const double whole = TowardZero ? std::trunc(scaled) : std::nearbyint(scaled);
    const double result = std::ldexp(whole, unit);
    if (std::abs(result) < std::ldexp(1.0, Greatest + 1)) return std::copysign(result, value);
    if (TowardZero) return std::copysign(std::ldexp(2 - std::ldexp(1.0, 1 - Precision), Greatest), value);
    return std::copysign(HUGE_VAL, value);
  }

  double value_ = 0;
};

using Binary16 = SmallFloat<11, 15>;
using BFloat16 = SmallFloat<8, 127>;

}  // namespace shortfall
