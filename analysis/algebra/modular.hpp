// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/wide.hpp"

namespace shortfall {

/// A number modulo the prime 2^61 - 1: a fingerprint of a rational.
///
/// Equal rationals have equal fingerprints; different ones collide with probability about 2^-61, so that
/// agreement is "checked", never "proved". Invariant: 0 <= value < 2^61 - 1.
class Modular {
 public:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

  Modular() = default;
  template <std::integral I>
  Modular(I value) : value_(from_integer(value)) {}
  /// throws  Undefined  when 2^61 - 1 divides the denominator
  explicit Modular(const Rational&);

  std::uint64_t value() const { return value_; }
  bool is_zero() const { return value_ == 0; }

  Modular operator-() const { return raw(value_ == 0 ? 0 : kPrime - value_); }
  Modular& operator+=(Modular other) {
    value_ += other.value_;
    if (value_ >= kPrime) value_ -= kPrime;
    return *this;
  }
  Modular& operator-=(Modular other) { return *this += -other; }
  Modular& operator*=(Modular other) {
    // 2^61 = 1 here: the upper half of the product is added to the lower.
    const UInt128 product = static_cast<UInt128>(value_) * other.value_;
    value_ = (static_cast<std::uint64_t>(product) & kPrime) + static_cast<std::uint64_t>(product >> 61);
    if (value_ >= kPrime) value_ -= kPrime;
    return *this;
  }
  Modular& operator/=(Modular other) {
    return *this *= other.inverse();
  }  ///< throws Undefined on division by zero
  friend Modular operator+(Modular a, Modular b) { return a += b; }
  friend Modular operator-(Modular a, Modular b) { return a -= b; }
  friend Modular operator*(Modular a, Modular b) { return a *= b; }
  friend Modular operator/(Modular a, Modular b) { return a /= b; }
  bool operator==(const Modular&) const = default;

  Modular inverse() const;                   ///< throws Undefined for zero
  Modular pow(std::int64_t exponent) const;  ///< throws Undefined for a negative power of zero

 private:
  static Modular raw(std::uint64_t value) {
    Modular result;
    result.value_ = value;
    return result;
  }
  template <std::integral I>
  static std::uint64_t from_integer(I value) {
    if constexpr (std::is_signed_v<I>) {
      const std::uint64_t rest = magnitude(static_cast<std::int64_t>(value)) % kPrime;
      return value < 0 && rest != 0 ? kPrime - rest : rest;
    } else {
      return static_cast<std::uint64_t>(value) % kPrime;
    }
  }
  std::uint64_t value_ = 0;
};

}  // namespace shortfall
