// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// An unevaluated sum of two binary64 numbers, about 106 bits. Not an IEEE format: results are accurate to a
/// few units of 2^-106, not correctly rounded.
///
/// Sources: Dekker (1971), A floating-point technique for extending the available precision; Joldes, Muller &
/// Popescu (2017), Tight and rigorous error bounds for basic building blocks of double-word arithmetic, ACM
/// Transactions on Mathematical Software 44 (AccurateDWPlusDW, DWTimesDW3, DWDivDW2: relative errors at most
/// 3 2^-106, 4 2^-106 and 15 2^-106).
class DoubleDouble {
 public:
  DoubleDouble() = default;
  explicit DoubleDouble(double value) : high_(value) {}
  DoubleDouble(double high, double low) : high_(high), low_(low) {}  ///< |low| <= ulp(high)/2

  double high() const { return high_; }
  double low() const { return low_; }

  DoubleDouble operator-() const { return {-high_, -low_}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto [s, e] = two_sum(a.high_, b.high_);
    if (!std::isfinite(s)) return DoubleDouble(s);
    const auto [t, f] = two_sum(a.low_, b.low_);
    const auto [v, w] = fast_two_sum(s, e + t);
    const auto [high, low] = fast_two_sum(v, f + w);
    return {high, low};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const double p = a.high_ * b.high_;
    if (!std::isfinite(p)) return DoubleDouble(p);
    const double e = std::fma(a.high_, b.high_, -p);
    const double cross = std::fma(a.low_, b.high_, std::fma(a.high_, b.low_, a.low_ * b.low_));
    const auto [high, low] = fast_two_sum(p, e + cross);
    return {high, low};
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double q = a.high_ / b.high_;
    if (!std::isfinite(q) || q == 0) return DoubleDouble(q);
    const DoubleDouble rest = a - b * DoubleDouble(q);
    const auto [high, low] = fast_two_sum(q, rest.high_ / b.high_);
    return {high, low};
  }
  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ == b.high_ && a.low_ == b.low_;
  }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }

  friend DoubleDouble sqrt(const DoubleDouble& a) {
    const double root = std::sqrt(a.high_);
    if (!std::isfinite(root) || root == 0) return DoubleDouble(root);
    // One step of Newton's iteration.
    const DoubleDouble rest = a - DoubleDouble(root) * DoubleDouble(root);
    const auto [high, low] = fast_two_sum(root, rest.high_ / (2 * root));
    return {high, low};
  }

 private:
  struct Pair {
    double sum, error;
  };
  static Pair two_sum(double a, double b) {
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static Pair fast_two_sum(double a, double b) {
    const double s = a + b;
    return {s, std::isfinite(s) ? b - (s - a) : 0};
  }

  double high_ = 0;
  double low_ = 0;
};

inline DoubleDouble abs(const DoubleDouble& a) { return a < DoubleDouble(0) ? -a : a; }

/// The sum of two binary64 numbers that is nearest to a rational; an infinity where that overflows.
DoubleDouble double_double(const Rational& value);

/// By MPFR, rounded to the two parts.
DoubleDouble sin(const DoubleDouble& a);
DoubleDouble cos(const DoubleDouble& a);
DoubleDouble exp(const DoubleDouble& a);
DoubleDouble log(const DoubleDouble& a);
DoubleDouble pow(const DoubleDouble& a, const DoubleDouble& b);

}  // namespace shortfall
