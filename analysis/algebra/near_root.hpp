// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

/// A rational within about 10^-digits, relatively, of an algebraic number; the number itself when it is
/// rational.
Rational near(const RealRoot& root, int digits);

/// So many digits of an irrational root are taken before it is rounded to a number of limited precision.
inline constexpr int kRoundedRootDigits = 120;

}  // namespace shortfall
