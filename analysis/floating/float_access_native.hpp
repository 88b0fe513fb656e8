// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <cmath>
#include <limits>

#include "analysis/floating/float_access.hpp"

#ifdef __FAST_MATH__
#error "floating-point runs mean nothing with -ffast-math"
#endif
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);
static_assert(std::numeric_limits<long double>::digits == 64, "x87 is the compiler's long double here");

namespace shortfall {

/// While it lives, the processor rounds toward zero.
class TowardZero {
 public:
  TowardZero() : saved_(std::fegetround()) { std::fesetround(FE_TOWARDZERO); }
  TowardZero(const TowardZero&) = delete;
  TowardZero& operator=(const TowardZero&) = delete;
  ~TowardZero() { std::fesetround(saved_); }

 private:
  int saved_;
};

/// What binary32, binary64 or x87 holds.
template <class T>
FloatNumber exactly(const T& value) {
  if (std::isnan(value)) return {FloatNumber::Kind::not_a_number, {}};
  if (std::isinf(value)) return {FloatNumber::Kind::infinite, value < 0 ? -1 : 1};
  if (value == 0) return {};
  int exponent = 0;
  T part = std::frexp(value, &exponent);
  Rational sum;
  // 32 bits a round: whole numbers that a binary64 holds.
  for (int shift = 0; part != 0; ++shift) {
    part = std::ldexp(part, 32);
    const T whole = std::trunc(part);
    sum += scaled_by_two(Rational(static_cast<std::int64_t>(whole)), -32L * (shift + 1));
    part -= whole;
  }
  return {FloatNumber::Kind::finite, scaled_by_two(sum, exponent)};
}

/// How numbers of the processor are made and read.
template <class T>
FloatAccess<T> native_access(const FloatFormat& format) {
  FloatAccess<T> a;
  const std::function<T(T, long)> scaled = [](T value, long e) {
    return std::ldexp(value, static_cast<int>(e));
  };
  a.rounded = [storage = format.storage(), rounding = format.rounding(), scaled](const Rational& value) {
    return stored_as<T>(value, storage, rounding, std::numeric_limits<T>::infinity(), scaled);
  };
  a.exact = [](const T& value) { return exactly(value); };
  a.rough = [](const T& value) { return static_cast<double>(value); };
  if (format.variant == FloatFormat::Variant::toward_zero)
    a.within = [](const std::function<void()>& work) {
      const TowardZero direction;
      work();
    };
  return a;
}

}  // namespace shortfall
