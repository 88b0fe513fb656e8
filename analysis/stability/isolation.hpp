// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

/// The shortest interval between two neighbouring decimals that tells a root from the others of its
/// polynomial: 2.8 and 2.9 for the positive root of x^2 - 8.
struct Isolation {
  std::string low;
  std::string high;
};

/// param   number  irrational
Isolation isolation(const RealRoot& number);

}  // namespace shortfall
