// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace shortfall {

/// An exact rational number of any size.
///
/// Invariant: in lowest terms, denominator positive; held in two 64-bit words while it fits (the common case,
/// three to ten times faster than a GMP rational when the numbers have few digits, see docs/performance.md),
/// in GMP integers otherwise. Equal numbers are represented equally.
class Rational {
 public:
  Rational() = default;
  template <std::integral I>
  Rational(I value) : Rational(from_integer(value)) {}
  /// throws  Undefined  when the denominator is zero
  Rational(std::int64_t numerator, std::int64_t denominator);
  Rational(const Rational& other)
      : numerator_(other.numerator_), denominator_(other.denominator_), big_(duplicate(other.big_.get())) {}
  Rational(Rational&& other) noexcept = default;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept = default;
  ~Rational() = default;

  /// The number a text stands for, exactly: "3", "-1/50", "0.02", "1.5e-3".
  ///
  /// throws  BadInput  when the text is no number, divides by zero, or would need more than 10,000 digits
  static Rational parse(std::string_view text);

  /// The rational that a finite binary64 stands for, exactly.
  ///
  /// throws  BadInput  when it is not finite
  static Rational from_double(double value);

  Rational numerator() const;
  Rational denominator() const;
  int sign() const {  ///< -1, 0 or 1
    return big_ ? big_sign() : (numerator_ > 0) - (numerator_ < 0);
  }
  bool is_zero() const { return numerator_ == 0 && !big_; }
  bool is_one() const { return numerator_ == 1 && denominator_ == 1 && !big_; }
  bool is_integer() const;
  /// The value when it is an integer that fits.
  bool fits_int64(std::int64_t& value) const;
  /// Numerator and denominator when both fit.
  bool fits_int64(std::int64_t& numerator, std::int64_t& denominator) const {
    numerator = numerator_;
    denominator = denominator_;
    return !big_;
  }

  Rational operator-() const;
  Rational& operator+=(const Rational&);
  Rational& operator-=(const Rational&);
  Rational& operator*=(const Rational&);
  Rational& operator/=(const Rational&);  ///< throws Undefined on division by zero
  friend Rational operator+(Rational a, const Rational& b) {
    a += b;
    return a;
  }
  friend Rational operator-(Rational a, const Rational& b) {
    a -= b;
    return a;
  }
  friend Rational operator*(Rational a, const Rational& b) {
    a *= b;
    return a;
  }
  friend Rational operator/(Rational a, const Rational& b) {
    a /= b;
    return a;
  }
  bool operator==(const Rational& other) const {
    return numerator_ == other.numerator_ && denominator_ == other.denominator_ &&
           (!big_ && !other.big_ ? true : big_equal(other));
  }
  std::strong_ordering operator<=>(const Rational&) const;

  /// This times above/below, two positive whole numbers: quicker than the product with a Rational, since
  /// common factors with short numbers are found by one remainder.
  Rational times(unsigned above, unsigned below) const;
  Rational abs() const { return sign() < 0 ? -*this : *this; }
  Rational floor() const;
  /// throws  Undefined  for a negative power of zero
  Rational pow(int exponent) const;

  /// The nearest binary64 / binary32, ties to even; overflow gives infinity (one correct rounding, subnormals
  /// included).
  double to_double() const;
  float to_float() const;

  /// "p/q", or "p" for an integer.
  std::string str() const;
  /// A decimal rounded to nearest (ties away from zero) with so many digits after the point: "-0.0275".
  std::string decimal(int places) const;
  /// A decimal rounded to so many significant digits; in the form 1.25e-09 outside [1e-6, 1e15).
  std::string significant(int digits) const;
  /// Decimal digits of the larger of numerator and denominator.
  std::size_t digits() const;
  std::size_t hash() const;

 private:
  friend struct RationalAccess;
  struct Big;  // a GMP rational, outside the 64-bit range; the two words then hold 0/1
  struct Discard {
    void operator()(Big*) const noexcept;
  };
  using BigPointer = std::unique_ptr<Big, Discard>;
  static BigPointer duplicate(const Big* big) { return big ? clone(*big) : BigPointer(); }
  static BigPointer clone(const Big&);
  int big_sign() const;
  bool big_equal(const Rational&) const;
  static Rational from_integer(std::int64_t value);
  static Rational from_integer(std::uint64_t value);
  template <std::integral I>
  static Rational from_integer(I value) {
    if constexpr (std::is_signed_v<I>)
      return from_integer(static_cast<std::int64_t>(value));
    else
      return from_integer(static_cast<std::uint64_t>(value));
  }

  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
  BigPointer big_;
};

std::ostream& operator<<(std::ostream&, const Rational&);

/// n choose k; zero outside 0..n.
Rational binomial(int n, int k);
Rational factorial(int n);

}  // namespace shortfall

template <>
struct std::hash<shortfall::Rational> {
  std::size_t operator()(const shortfall::Rational& r) const { return r.hash(); }
};
