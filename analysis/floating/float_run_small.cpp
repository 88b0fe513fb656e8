// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access.hpp"
#include "analysis/floating/float_variants.hpp"
#include "analysis/floating/small_float.hpp"

namespace shortfall {

namespace {

template <class T>
FloatAccess<T> access(const FloatFormat& format) {
  FloatAccess<T> a;
  a.rounded = [storage = format.storage(), rounding = format.rounding()](const Rational& value) {
    const auto r = rounded(value, storage, rounding);
    return T(r ? r->to_double() : value.sign() < 0 ? -HUGE_VAL : HUGE_VAL);
  };
  a.exact = [](const T& value) -> FloatNumber {
    if (std::isnan(value.value())) return {FloatNumber::Kind::not_a_number, {}};
    if (std::isinf(value.value())) return {FloatNumber::Kind::infinite, value.value() < 0 ? -1 : 1};
    return {FloatNumber::Kind::finite, Rational::from_double(value.value())};
  };
  a.rough = [](const T& value) { return value.value(); };
  return a;
}

template <int Precision, int Greatest>
std::unique_ptr<FloatRun> made(const FloatFormat& format, const FloatQuestion& q) {
  using Nearest = SmallFloat<Precision, Greatest>;
  switch (format.variant) {
    case FloatFormat::Variant::fused:
      return std::make_unique<TypedFloatRun<Fused<Nearest>>>(
          q, wrapped<Fused<Nearest>>(access<Nearest>(format)));
    case FloatFormat::Variant::compensated:
      return std::make_unique<TypedFloatRun<Compensated<Nearest>>>(
          q, wrapped<Compensated<Nearest>>(access<Nearest>(format)));
    case FloatFormat::Variant::toward_zero: {
      using Directed = SmallFloat<Precision, Greatest, true>;
      return std::make_unique<TypedFloatRun<Directed>>(q, access<Directed>(format));
    }
    case FloatFormat::Variant::plain:
    case FloatFormat::Variant::offset:
      break;
  }
  return std::make_unique<TypedFloatRun<Nearest>>(q, access<Nearest>(format));
}

}  // namespace

std::unique_ptr<FloatRun> small_float_run(const FloatFormat& format, const FloatQuestion& question) {
  return format.kind == FloatFormat::Kind::binary16 ? made<11, 15>(format, question)
                                                    : made<8, 127>(format, question);
}

}  // namespace shortfall
