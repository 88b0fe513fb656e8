// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "analysis/floating/float_access.hpp"
#include "analysis/floating/small_float.hpp"

namespace shortfall {

/// How numbers of 16 bits are made and read.
template <class T>
FloatAccess<T> small_access(const FloatFormat& format) {
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

}  // namespace shortfall
