// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <string>

#include "analysis/audit/audit.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// Claims with what became of them, then probable mends.
std::string as_text(const Audit& audit, Style style);

nlohmann::ordered_json as_json(const Audit& audit);

/// "entry", "exact value": what a mend is called.
std::string kind_text(Mend::Kind kind);

}  // namespace shortfall
