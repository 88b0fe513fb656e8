// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/trade/trade.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// What is cheap enough for what: for each way of stepping its cheapest point within the tolerances, the
/// orders, what failed.
std::string as_text(const Trade& trade);
/// Every point, one line each; times in nanoseconds for the whole scene.
std::string as_csv(const Trade& trade);
nlohmann::ordered_json as_json(const Trade& trade);

/// Error against cost, a panel for each observable: the tolerance as a shaded region, floors of the formats
/// dashed, the Pareto front marked.
Figure trade_figure(const Trade& trade);

/// "1.2 us", "3.4 ms": nanoseconds for a reader.
std::string duration_text(double nanoseconds);
/// Up to six significant digits, without zeros behind them.
std::string short_number(const Rational& value);
/// "3.4e-05 m": three significant digits and the unit.
std::string error_text(double value, const std::string& unit);

}  // namespace shortfall
