// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/correction/linear_kit.hpp"
#include "analysis/motion/numeric_motion.hpp"

namespace shortfall {

/// One replacement in numbers: target := sum of number * name, a name being empty for a number alone.
struct NumericCorrection {
  std::string target;
  std::vector<std::pair<CertainNumber, std::string>> terms;
};

/// A kit for one step length and one spring: what is typed into an engine.
struct KitNumbers {
  std::vector<NumericCorrection> corrections;  ///< in the order of the kit's
  bool solved =
      false;  ///< k_new, c_new are roots of equations, proved to exist and to be the only ones nearby
};

/// The numbers of a kit, each digit certain. Roots of equations are found by Newton's method, followed from
/// small steps up to h, and proved by an interval Newton step: an operator that takes a box into itself has
/// one root in it.
///
/// param   force  with k and c as numbers
/// throws  BadInput  when a letter has no number;  Unable  when no root is proved
/// source  Moore (1966), Interval Analysis; Krawczyk (1969)
KitNumbers kit_numbers(const LinearKit& kit, const Force& force, const Values& parameters, const Rational& h,
                       int digits = 30);

}  // namespace shortfall
