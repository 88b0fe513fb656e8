// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// A run to hold other implementations against: the force t - 2 x - v/4, from x = 1/2, v = -3/4, t = 0.
struct FirstSteps {
  double dt;              ///< 0.1, rounded to the format
  std::vector<double> x;  ///< as reported after each step
  std::vector<double> v;
};

/// In binary32 or binary64, operation by operation; every binary32 number is one of binary64 as well.
FirstSteps first_steps(const Program& program, const Values& given, bool binary32, int count);

}  // namespace shortfall
