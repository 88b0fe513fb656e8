// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/trade/scene_run.hpp"

namespace shortfall {

/// Hexadecimal, so that a number comes back with all its bits; infinities and NaN as words.
std::string bits_text(double value);
std::string bits_text(const std::vector<double>& values);
double bits_of(const std::string& text);
std::vector<double> all_bits_of(const std::string& text);

/// An outcome (but for how it was stepped, which whoever asked knows) on one line, for another machine; bit
/// for bit.
std::string as_line(const SceneOutcome& outcome);
SceneOutcome outcome_of_line(const std::string& line);

}  // namespace shortfall
