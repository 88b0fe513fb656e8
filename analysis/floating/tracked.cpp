// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/tracked.hpp"

#include <quadmath.h>

namespace shortfall {

namespace {
__extension__ typedef __float128 Wide;
}

long double exp_shortfall(long double value, long double error, long double computed) {
  return static_cast<long double>(expq(Wide(value) + Wide(error)) - Wide(computed));
}

long double log_shortfall(long double value, long double error, long double computed) {
  return static_cast<long double>(logq(Wide(value) + Wide(error)) - Wide(computed));
}

long double pow_shortfall(long double value, long double error, long double exponent,
                          long double exponent_error, long double computed) {
  return static_cast<long double>(powq(Wide(value) + Wide(error), Wide(exponent) + Wide(exponent_error)) -
                                  Wide(computed));
}

}  // namespace shortfall
