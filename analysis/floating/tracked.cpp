// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/tracked.hpp"

#include <quadmath.h>

namespace shortfall {

namespace {
__extension__ typedef __float128 Float128;
}

long double exp_shortfall(long double value, long double error, long double computed) {
  return static_cast<long double>(expq(Float128(value) + Float128(error)) - Float128(computed));
}

long double log_shortfall(long double value, long double error, long double computed) {
  return static_cast<long double>(logq(Float128(value) + Float128(error)) - Float128(computed));
}

long double pow_shortfall(long double value, long double error, long double exponent,
                          long double exponent_error, long double computed) {
  return static_cast<long double>(
      powq(Float128(value) + Float128(error), Float128(exponent) + Float128(exponent_error)) -
      Float128(computed));
}

}  // namespace shortfall
