// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A binary64 to so many significant digits, rounded from its exact value.
inline std::string double_text(double value, int digits) {
  return Rational::from_double(value).significant(digits);
}

}  // namespace shortfall
