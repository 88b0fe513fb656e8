// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access_small.hpp"
#include "analysis/floating/float_variants.hpp"

namespace shortfall {

namespace {

template <int Precision, int Greatest>
std::unique_ptr<FloatRun> made(const FloatFormat& format, const FloatQuestion& q) {
  using Nearest = SmallFloat<Precision, Greatest>;
  switch (format.variant) {
    case FloatFormat::Variant::fused:
      return std::make_unique<TypedFloatRun<Fused<Nearest>>>(
          q, wrapped<Fused<Nearest>>(small_access<Nearest>(format)));
    case FloatFormat::Variant::compensated:
      return std::make_unique<TypedFloatRun<Compensated<Nearest>>>(
          q, wrapped<Compensated<Nearest>>(small_access<Nearest>(format)));
    case FloatFormat::Variant::toward_zero: {
      using Directed = SmallFloat<Precision, Greatest, true>;
      return std::make_unique<TypedFloatRun<Directed>>(q, small_access<Directed>(format));
    }
    case FloatFormat::Variant::plain:
    case FloatFormat::Variant::offset:
      break;
  }
  return std::make_unique<TypedFloatRun<Nearest>>(q, small_access<Nearest>(format));
}

}  // namespace

std::unique_ptr<FloatRun> small_float_run(const FloatFormat& format, const FloatQuestion& question) {
  return format.kind == FloatFormat::Kind::binary16 ? made<11, 15>(format, question)
                                                    : made<8, 127>(format, question);
}

}  // namespace shortfall
