// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/rational.hpp"

namespace shortfall {

// Where the examples of notebooks and lessons take place.
inline const Rational kExampleFrame(1, 50);       ///< s
inline const Rational kExampleGravity(981, 100);  ///< m/s^2

}  // namespace shortfall
