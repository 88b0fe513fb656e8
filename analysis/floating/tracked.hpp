// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <type_traits>

#include "analysis/floating/float_variants.hpp"

namespace shortfall {

/// What the error of a T is held in: binary64 for what is shorter, T itself otherwise.
template <class T>
using ErrorOf = std::conditional_t<std::is_same_v<T, double> || std::is_same_v<T, long double>, T, double>;

template <class T>
ErrorOf<T> as_error(const T& value) {
  if constexpr (requires { value.value(); })
    return value.value();
  else
    return value;
}

/// A number and its accumulated rounding error, exact minus computed: value() is, bit for bit, what T alone
/// computes, and value() + error() what exact arithmetic would have made of the same start.
///
/// Each operation's own error is found exactly (two-sum; fused multiply-add for products, quotients and
/// roots) and added to what the operands' errors become in it, products of two errors included. So the error
/// is wrong only by its own rounding: by a few units of 2^-53 (2^-64 for x87) of the errors that went into
/// it, a step; and where a product of binary64 numbers is below 2^-969, by 2^-1074. T has to round to
/// nearest.
///
/// source  Knuth (1969), The Art of Computer Programming 2, 4.2.2, Theorem B (two-sum); Dekker (1971), A
/// floating-point technique for extending the available precision; Ogita, Rump & Oishi (2005), Accurate sum
/// and dot product; Boldo & Muller (2011), Exact and approximated error of the FMA
template <class T>
class Tracked {
 public:
  using Error = ErrorOf<T>;

  Tracked() = default;
  explicit Tracked(T value, Error error = 0) : value_(value), error_(error) {}

  const T& value() const { return value_; }
  const Error& error() const { return error_; }

  Tracked operator-() const { return Tracked(-value_, -error_); }
  friend Tracked operator+(const Tracked& a, const Tracked& b) {
    return sum(a.value_, b.value_, a.error_ + b.error_);
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b) {
    return sum(a.value_, -b.value_, a.error_ - b.error_);
  }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    const T p = a.value_ * b.value_;
    const Error from_a = a.error_ * as_error(b.value_), from_b = b.error_ * (as_error(a.value_) + a.error_);
    return Tracked(p, rest(a.value_, b.value_, p) + (from_a + from_b));
  }
  /// By a factor that is meant as it is: nothing of its own goes into the error.
  friend Tracked operator*(const T& a, const Tracked& b) {
    const T p = a * b.value_;
    return Tracked(p, rest(a, b.value_, p) + as_error(a) * b.error_);
  }
  friend Tracked operator/(const Tracked& a, const Tracked& b) {
    const T q = a.value_ / b.value_;
    // (a + ea) / (b + eb) - q = (a - q b + ea - q eb) / (b + eb)
    const Error remainder = -rest(q, b.value_, a.value_);
    return Tracked(q, (remainder + (a.error_ - as_error(q) * b.error_)) / (as_error(b.value_) + b.error_));
  }
  friend bool operator==(const Tracked& a, const Tracked& b) { return a.value_ == b.value_; }
  friend bool operator<(const Tracked& a, const Tracked& b) { return a.value_ < b.value_; }

  /// a b + c, rounded once.
  friend Tracked fma(const Tracked& a, const Tracked& b, const Tracked& c) {
    using std::fma;
    const T r = fma(a.value_, b.value_, c.value_);
    // p + low is the product, s + lost its sum with c: what is left of them without r.
    const Error x = as_error(a.value_), y = as_error(b.value_), z = as_error(c.value_);
    const Error p = x * y, low = std::fma(x, y, -p);
    const Pair with_low = two_sum(z, low), with_p = two_sum(p, with_low.sum);
    const Error own = ((with_p.sum - as_error(r)) + with_p.error) + with_low.error;
    return Tracked(r, own + (c.error_ + (a.error_ * y + b.error_ * (x + a.error_))));
  }
  friend Tracked sqrt(const Tracked& a) {
    using std::sqrt;
    const T root = sqrt(a.value_);
    const Error r = as_error(root);
    if (!(r > 0)) return Tracked(root);
    // sqrt(a + ea) - r = (a - r^2 + ea) / (sqrt(a + ea) + r)
    const Error moved = a.error_ - rest(root, root, a.value_);
    return Tracked(root, moved / (std::sqrt(as_error(a.value_) + a.error_) + r));
  }

 private:
  struct Pair {
    Error sum, error;
  };
  static Pair two_sum(Error a, Error b) {
    const Error s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static Tracked sum(const T& a, const T& b, Error carried) {
    const T s = a + b, part = s - a;
    const T own = (a - (s - part)) + (b - part);
    return Tracked(s, as_error(own) + carried);
  }
  /// a b - p: exact, where p is that product rounded or a quotient's dividend.
  static Error rest(const T& a, const T& b, const T& p) {
    if constexpr (std::is_same_v<T, Error>)
      return std::fma(a, b, -p);
    else  // two numbers of at most 24 bits: binary64 holds their product
      return as_error(a) * as_error(b) - as_error(p);
  }

  T value_{};
  Error error_ = 0;
};

/// What functions lose, by way of binary128: f(value + error) - computed.
long double exp_shortfall(long double value, long double error, long double computed);
long double log_shortfall(long double value, long double error, long double computed);
long double pow_shortfall(long double value, long double error, long double exponent,
                          long double exponent_error, long double computed);

template <class T>
Tracked<T> exp(const Tracked<T>& a) {
  using std::exp;
  const T y = exp(a.value());
  return Tracked<T>(y, static_cast<ErrorOf<T>>(exp_shortfall(as_error(a.value()), a.error(), as_error(y))));
}
template <class T>
Tracked<T> log(const Tracked<T>& a) {
  using std::log;
  const T y = log(a.value());
  return Tracked<T>(y, static_cast<ErrorOf<T>>(log_shortfall(as_error(a.value()), a.error(), as_error(y))));
}
template <class T>
Tracked<T> pow(const Tracked<T>& a, const Tracked<T>& b) {
  using std::pow;
  const T y = pow(a.value(), b.value());
  return Tracked<T>(y, static_cast<ErrorOf<T>>(pow_shortfall(as_error(a.value()), a.error(),
                                                             as_error(b.value()), b.error(), as_error(y))));
}

/// The accumulated rounding error of what is tracked; only such numbers have one.
template <class T>
ErrorOf<T> rounding_of(const Tracked<T>& x) {
  return x.error();
}
template <class T>
ErrorOf<T> rounding_of(const Fused<Tracked<T>>& x) {
  return x.value().error();
}
template <class T>
ErrorOf<T> rounding_of(const Compensated<Tracked<T>>& x) {
  return x.value().error();
}

}  // namespace shortfall
