// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access_native.hpp"
#include "analysis/floating/tracked_run.hpp"

namespace shortfall {

std::unique_ptr<FloatRun> native_tracked_run(const FloatFormat& format, const FloatQuestion& q) {
  if (format.kind == FloatFormat::Kind::binary32)
    return typed_tracked_run(format, q, native_access<float>(format));
  if (format.kind == FloatFormat::Kind::binary64)
    return typed_tracked_run(format, q, native_access<double>(format));
  return typed_tracked_run(format, q, native_access<long double>(format));
}

}  // namespace shortfall
