// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/floating/float_run.hpp"

namespace shortfall {

/// A hard case with a known answer: what is exact, what a format gives, and why.
struct ExtremeCase {
  std::string name;
  std::string asked;  ///< "0.1 added 1,000,000 times"
  std::string exact;
  std::string computed;
  std::string why;
  bool lost = false;  ///< the answer is of no use: wrong in its first digit, not finite, or it does not move
};

/// Cases about sums, clocks and formulas, which need no integrator.
std::vector<ExtremeCase> extreme_sums(const FloatFormat& format);

/// Cases about a step: far from the origin, at the limits of stability, at the ends of the format's range.
///
/// A case that the integrator cannot be asked (a force that it has no limit for, a step that is not linear)
/// is left out.
std::vector<ExtremeCase> extreme_steps(const FloatFormat& format, const Program& program,
                                       const Values& parameters);

}  // namespace shortfall
