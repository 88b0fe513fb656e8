// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/program/print.hpp"
#include "analysis/series/invariants.hpp"
#include "analysis/series/order.hpp"
#include "analysis/series/processing.hpp"
#include "analysis/series/structure.hpp"

namespace shortfall {

/// Everything that the command `order` answers.
struct OrderReport {
  Order order;
  Structure structure;
  Processing processing;  ///< for a(x, t): the effective order
  EnergyChange energy;

  /// Whether trees that do not fit ended the search in some class.
  bool cut_short() const;
};

std::string as_text(const OrderReport& report, const SeriesSource& source, Style style);

/// Schema shortfall.order/1.
nlohmann::ordered_json as_json(const OrderReport& report, const SeriesSource& source);

}  // namespace shortfall
