// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/floating/float_access.hpp"
#include "analysis/floating/tracked.hpp"

namespace shortfall {

/// A run in Tracked<T>, where the format rounds to nearest.
template <class T>
std::unique_ptr<FloatRun> typed_tracked_run(const FloatFormat& format, const FloatQuestion& q,
                                            const FloatAccess<T>& plain) {
  using Number = Tracked<T>;
  const FloatAccess<Number> access = wrapped<Number>(plain);
  switch (format.variant) {
    case FloatFormat::Variant::plain:
      return std::make_unique<TypedFloatRun<Number>>(q, access);
    case FloatFormat::Variant::fused:
      return std::make_unique<TypedFloatRun<Fused<Number>>>(q, wrapped<Fused<Number>>(access));
    case FloatFormat::Variant::compensated:
      return std::make_unique<TypedFloatRun<Compensated<Number>>>(q, wrapped<Compensated<Number>>(access));
    case FloatFormat::Variant::offset:
    case FloatFormat::Variant::toward_zero:  // what a sum loses then is no number of the format
      break;
  }
  return nullptr;
}

}  // namespace shortfall
