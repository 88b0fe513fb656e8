// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/trade/trade.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// For each way of stepping its cheapest point within all tolerances, as a table with its heads in the first
/// row; the cheapest of all is marked with a star.
struct CheapestPoints {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> unable;  ///< those that meet the tolerances at no step that was tried
};
CheapestPoints cheapest_points(const Trade& trade);

/// What is cheap enough for what: for each way of stepping its cheapest point within the tolerances, the
/// orders, what failed.
std::string as_text(const Trade& trade);
/// Every point, one line each; times in nanoseconds for the whole scene.
std::string as_csv(const Trade& trade);
nlohmann::ordered_json as_json(const Trade& trade);

/// Error against cost, a panel for each observable: the tolerance as a shaded region, floors of the formats
/// dashed, the Pareto front marked.
Figure trade_figure(const Trade& trade);

/// The same as a page, with the drawing where gnuplot is installed and every point in a table.
///
/// param   command  what makes this page
std::string trade_page(const Trade& trade, const std::string& command);

/// "1.2 us", "3.4 ms": nanoseconds for a reader.
std::string duration_text(double nanoseconds);
/// Up to six significant digits, without zeros behind them.
std::string short_number(const Rational& value);
/// "3.4e-05 m": three significant digits and the unit.
std::string error_text(double value, const std::string& unit);

}  // namespace shortfall
