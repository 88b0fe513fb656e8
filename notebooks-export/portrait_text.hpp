// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/trade/portrait.hpp"

namespace shortfall {

/// What becomes of the energy along each motion, as a table.
std::string as_text(const Portrait& portrait);

/// A line for each frame of each motion.
std::string as_csv(const Portrait& portrait);

/// Schema shortfall.portrait/1: numbers in binary64; `change` is the value less that at the start.
nlohmann::ordered_json as_json(const Portrait& portrait);

}  // namespace shortfall
