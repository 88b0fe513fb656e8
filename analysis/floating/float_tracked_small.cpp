// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/float_access_small.hpp"
#include "analysis/floating/tracked_run.hpp"

namespace shortfall {

std::unique_ptr<FloatRun> small_tracked_run(const FloatFormat& format, const FloatQuestion& q) {
  return format.kind == FloatFormat::Kind::binary16
             ? typed_tracked_run(format, q, small_access<Binary16>(format))
             : typed_tracked_run(format, q, small_access<BFloat16>(format));
}

}  // namespace shortfall
