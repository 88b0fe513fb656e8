// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "analysis/algebra/rational.hpp"
#include "analysis/floating/double_double.hpp"

namespace shortfall {

/// A rational in the numbers that a scene is stepped with, rounded once. S is float, double or DoubleDouble.
template <class S>
S rounded_number(const Rational& value) {
  if constexpr (std::is_same_v<S, float>)
    return value.to_float();
  else if constexpr (std::is_same_v<S, double>)
    return value.to_double();
  else
    return double_double(value);
}

}  // namespace shortfall
