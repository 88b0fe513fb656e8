// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/floating/extremes.hpp"

namespace shortfall {

/// Hard cases as a person reads them: what is exact, what the format gives, why.
std::string as_text(const std::vector<ExtremeCase>& cases, const std::string& title);
nlohmann::ordered_json as_json(const std::vector<ExtremeCase>& cases);

}  // namespace shortfall
