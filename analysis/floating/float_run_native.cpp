// SPDX-License-Identifier: GPL-3.0-or-later
#include <cfenv>
#include <cmath>
#include <limits>

#include "analysis/floating/float_access.hpp"
#include "analysis/floating/float_variants.hpp"

#ifdef __FAST_MATH__
#error "floating-point runs mean nothing with -ffast-math"
#endif
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);
static_assert(std::numeric_limits<long double>::digits == 64, "x87 is the compiler's long double here");

namespace shortfall {

namespace {

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

template <class T>
FloatAccess<T> access(const FloatFormat& format) {
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

FloatAccess<OffsetFloat> offset_access() {
  FloatAccess<OffsetFloat> a;
  a.rounded = [](const Rational& value) {
    const Rational origin = value.abs().floor() * Rational(value.sign());
    return OffsetFloat(origin.to_double(), (value - origin).to_float());
  };
  a.exact = [](const OffsetFloat& value) -> FloatNumber {
    const FloatNumber origin = exactly(value.origin()), offset = exactly(value.offset());
    if (!origin.is_finite()) return origin;
    if (!offset.is_finite()) return offset;
    return {FloatNumber::Kind::finite, origin.value + offset.value};
  };
  a.rough = [](const OffsetFloat& value) { return value.origin() + static_cast<double>(value.offset()); };
  return a;
}

template <class T>
std::unique_ptr<FloatRun> made(const FloatFormat& format, const FloatQuestion& q) {
  switch (format.variant) {
    case FloatFormat::Variant::fused:
      return std::make_unique<TypedFloatRun<Fused<T>>>(q, wrapped<Fused<T>>(access<T>(format)));
    case FloatFormat::Variant::compensated:
      return std::make_unique<TypedFloatRun<Compensated<T>>>(q, wrapped<Compensated<T>>(access<T>(format)));
    case FloatFormat::Variant::plain:
    case FloatFormat::Variant::offset:
    case FloatFormat::Variant::toward_zero:
      break;
  }
  return std::make_unique<TypedFloatRun<T>>(q, access<T>(format));
}

}  // namespace

std::unique_ptr<FloatRun> native_float_run(const FloatFormat& format, const FloatQuestion& question) {
  if (format.variant == FloatFormat::Variant::offset)
    return std::make_unique<TypedFloatRun<OffsetFloat>>(question, offset_access());
  if (format.kind == FloatFormat::Kind::binary32) return made<float>(format, question);
  if (format.kind == FloatFormat::Kind::binary64) return made<double>(format, question);
  return made<long double>(format, question);
}

}  // namespace shortfall
