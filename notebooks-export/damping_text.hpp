// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/correction/damping_report.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// A damping report as a person reads it.
std::string as_text(const DampingReport& report, Style style);

/// Schema shortfall.damping/1.
nlohmann::ordered_json as_json(const DampingReport& report);

/// One line an integrator: what one damping number means in each. `refused`: integrators and why not.
std::string damping_table(const std::vector<DampingReport>& reports,
                          const std::vector<std::pair<std::string, std::string>>& refused, Style style);
nlohmann::ordered_json damping_table_json(const std::vector<DampingReport>& reports,
                                          const std::vector<std::pair<std::string, std::string>>& refused);

}  // namespace shortfall
