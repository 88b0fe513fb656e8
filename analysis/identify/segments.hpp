// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/identify/identification.hpp"
#include "analysis/identify/match.hpp"

namespace shortfall {

/// What must be fitted besides launch and acceleration, with guesses; found with the positions alone, which
/// every map with two carried vectors can make when its parameters are free.
std::optional<FitQuestion> needed(const Observations& observations);

/// Rows of a log that stand still at its beginning and at its end are no part of a motion.
///
/// shape   the rows in between; breaks are added
void trim(const Log& log, std::size_t& first, std::size_t& last, std::vector<Break>& breaks);

/// The longest beginning of the rows that one map can make, from `first` on.
std::size_t longest(const Log& log, double dt, std::size_t first, std::size_t last);

/// What happens at a row that the map does not explain any more.
Break break_at(const Log& log, std::size_t first, std::size_t row);

}  // namespace shortfall
