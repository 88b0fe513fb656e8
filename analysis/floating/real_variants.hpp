// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "analysis/algebra/real.hpp"
#include "analysis/floating/wrapped_number.hpp"

namespace shortfall {

/// Boost fixes the rounding of MPFR's operations to nearest; for the other direction they are written out.
class RealTowardZero {
 public:
  using Inner = Real;
  RealTowardZero() = default;
  explicit RealTowardZero(Real value) : value_(std::move(value)) {}
  const Real& value() const { return value_; }

  RealTowardZero operator-() const { return RealTowardZero(-value_); }
  friend RealTowardZero operator+(const RealTowardZero& a, const RealTowardZero& b) {
    return made(mpfr_add, a, b);
  }
  friend RealTowardZero operator-(const RealTowardZero& a, const RealTowardZero& b) {
    return made(mpfr_sub, a, b);
  }
  friend RealTowardZero operator*(const RealTowardZero& a, const RealTowardZero& b) {
    return made(mpfr_mul, a, b);
  }
  friend RealTowardZero operator/(const RealTowardZero& a, const RealTowardZero& b) {
    return made(mpfr_div, a, b);
  }
  friend bool operator==(const RealTowardZero& a, const RealTowardZero& b) { return a.value_ == b.value_; }
  friend bool operator<(const RealTowardZero& a, const RealTowardZero& b) { return a.value_ < b.value_; }

 private:
  template <class Operation>
  static RealTowardZero made(Operation operation, const RealTowardZero& a, const RealTowardZero& b) {
    Real result;  // of the current precision
    operation(result.backend().data(), a.value_.backend().data(), b.value_.backend().data(), MPFR_RNDZ);
    return RealTowardZero(std::move(result));
  }
  Real value_;
};

/// A Real with fma beside it, where Fused looks for it.
class FusedReal {
 public:
  using Inner = Real;
  FusedReal() = default;
  explicit FusedReal(Real value) : value_(std::move(value)) {}
  const Real& value() const { return value_; }

  FusedReal operator-() const { return FusedReal(-value_); }
  friend FusedReal operator+(const FusedReal& a, const FusedReal& b) {
    return FusedReal(a.value_ + b.value_);
  }
  friend FusedReal operator-(const FusedReal& a, const FusedReal& b) {
    return FusedReal(a.value_ - b.value_);
  }
  friend FusedReal operator*(const FusedReal& a, const FusedReal& b) {
    return FusedReal(a.value_ * b.value_);
  }
  friend FusedReal operator/(const FusedReal& a, const FusedReal& b) {
    return FusedReal(a.value_ / b.value_);
  }
  friend bool operator==(const FusedReal& a, const FusedReal& b) { return a.value_ == b.value_; }
  friend bool operator<(const FusedReal& a, const FusedReal& b) { return a.value_ < b.value_; }
  friend FusedReal fma(const FusedReal& a, const FusedReal& b, const FusedReal& c) {
    Real result;  // of the current precision
    mpfr_fma(result.backend().data(), a.value_.backend().data(), b.value_.backend().data(),
             c.value_.backend().data(), MPFR_RNDN);
    return FusedReal(std::move(result));
  }

 private:
  Real value_;
};

}  // namespace shortfall
