// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shortfall {

/// "; did you mean 'h'?" when a candidate is close to the word or known to mean the same, else "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// The candidate nearest to the word by edit distance, or "" when none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace shortfall
