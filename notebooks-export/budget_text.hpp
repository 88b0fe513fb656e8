// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/floating/budget.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// Budgets of one question in several formats, as tables: a row for each format, a column for each part.
///
/// param   about  what was asked, on the first line
std::string as_text(const std::vector<Budget>& budgets, const std::string& about);

/// Schema shortfall.budget/1. Numbers are exact fractions where they are short, decimals with a radius
/// otherwise; signs as everywhere: exact minus computed.
nlohmann::ordered_json as_json(const std::vector<Budget>& budgets);

/// A waterfall: from the exact value downwards through the parts to what the run says, one panel a format.
Figure budget_figure(const std::vector<Budget>& budgets, const std::string& title);

}  // namespace shortfall
