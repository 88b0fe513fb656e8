// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/stability/stability.hpp"

namespace shortfall {

/// Schema shortfall.stability/1. Formulas are strings of the .integrator language, in h, w (the frequency),
/// c, z and parameters.
nlohmann::ordered_json as_json(const Stability& stability);

}  // namespace shortfall
