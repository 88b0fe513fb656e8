// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/closed_form.hpp"

namespace shortfall {

/// One quantity of the derivation: a carried vector, or a difference of carried vectors that makes the system
/// triangular.
///
/// Its step is  next = self * now + sum(weights * earlier quantities) + drive.
struct Quantity {
  std::string name;
  LinearForm definition;  ///< in the carried vectors
  Fraction self;
  std::vector<std::pair<int, Fraction>>
      weights;           ///< index of an earlier quantity of the story, its coefficient
  LinearForm drive;      ///< in the force columns, polynomials in n
  bool solvable = true;  ///< false: not triangular; only its result is shown
};

/// The quantities in an order in which each depends on itself and on earlier ones only; those that nobody
/// sees are left out.
///
/// Where two carried vectors depend on each other, as positions of a two-step method do, their difference is
/// introduced.
std::vector<Quantity> story(const StepMap& map);

}  // namespace shortfall
