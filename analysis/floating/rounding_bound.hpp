// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/floating/float_run.hpp"

namespace shortfall {

/// A bound of what rounding does to x in so many steps: what one step can round at most, where |x| and |v|
/// are no larger than the run's, added up over all steps through the powers of the step's matrix.
///
/// None when the step solves for a stage or calls functions, or reports something other than it carries, and
/// for formats that do not round each operation once.
///
/// source  Higham (2002), Accuracy and Stability of Numerical Algorithms, 3.3 (running error analysis)
std::optional<double> rounding_bound(const FloatFormat& format, const FloatQuestion& stored_question,
                                     std::int64_t steps, double largest_x, double largest_v);

}  // namespace shortfall
