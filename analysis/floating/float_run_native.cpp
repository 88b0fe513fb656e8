// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access_native.hpp"
#include "analysis/floating/float_variants.hpp"

namespace shortfall {

namespace {

FloatAccess<OffsetFloat> offset_access() {
  FloatAccess<OffsetFloat> a;
  a.rounded = [](const Rational& value) {
    const Rational origin = value.abs().floor() * Rational(value.sign());
    return OffsetFloat(origin.to_double(), (value - origin).to_float());
  };
  a.exact = [](const OffsetFloat& value) -> FloatNumber {
    FloatNumber origin = exactly(value.origin()), offset = exactly(value.offset());
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
      return std::make_unique<TypedFloatRun<Fused<T>>>(q, wrapped<Fused<T>>(native_access<T>(format)));
    case FloatFormat::Variant::compensated:
      return std::make_unique<TypedFloatRun<Compensated<T>>>(
          q, wrapped<Compensated<T>>(native_access<T>(format)));
    case FloatFormat::Variant::plain:
    case FloatFormat::Variant::offset:
    case FloatFormat::Variant::toward_zero:
      break;
  }
  return std::make_unique<TypedFloatRun<T>>(q, native_access<T>(format));
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
