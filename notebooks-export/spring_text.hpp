// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/correction/spring_report.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// A spring report as a person reads it, with the engine's native (implicit) spring beside it.
std::string as_text(const SpringReport& report, const SpringReport& native, Style style);

/// Schema shortfall.spring/1.
nlohmann::ordered_json as_json(const SpringReport& report, const SpringReport& native);

}  // namespace shortfall
