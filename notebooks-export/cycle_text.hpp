// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/floating/cycle.hpp"

namespace shortfall {

/// A cycle as a person reads it: when it repeats itself, and what is then certain for all time.
std::string as_text(const CycleSearch& search, const FloatFormat& format, const FloatQuestion& question);

/// One entry of shortfall.cycle/1.
nlohmann::ordered_json as_json(const CycleSearch& search, const FloatFormat& format,
                               const FloatQuestion& question);

}  // namespace shortfall
