// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/identify/identification.hpp"

namespace shortfall {

/// What a map leaves unexplained of one row of a log.
struct Residual {
  double time = 0;        ///< seconds since the log's first row
  Log::Triple missing{};  ///< recorded minus computed position, in the log's unit
};

/// The rows that were explained, beside a match with its fitted numbers; where it makes every bit, with the
/// numbers of its run.
///
/// throws  Error  where the map explodes
std::vector<Residual> residuals(const Log& log, const Identification& found, const Match& match);

}  // namespace shortfall
