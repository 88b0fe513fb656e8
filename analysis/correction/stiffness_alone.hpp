// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/correction/open_step.hpp"

namespace shortfall {

/// Why no stiffness by itself makes the frequency of a spring exact.
///
/// params  step         with the stiffness still a letter
///         obstruction  what the matching found
///         names        of the letters
std::string why_not_stiffness_alone(const OpenStep& step, const std::string& obstruction,
                                    const std::vector<std::string>& names);

}  // namespace shortfall
