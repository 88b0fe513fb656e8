// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/conjugation.hpp"

#include <algorithm>
#include <map>

namespace shortfall {

Conjugation::Conjugation(const TreeTable& table, int order, std::vector<TreeId> free)
    : free_(std::move(free)) {
  const auto is_clock = [&](TreeId t) { return table.signature().components[table.component(t)] == "t"; };
  for (const bool others : {false, true})
    for (TreeId t = table.begin(order - 1); t < table.end(order - 1); ++t)
      if ((table.function(t) != 0) == others && !is_clock(t)) unknowns_.push_back(t);
  std::map<TreeId, std::size_t> column;
  for (TreeId t : unknowns_) column.emplace(t, column.size());
  const std::size_t columns = unknowns_.size() + free_.size();
  for (TreeId t = table.begin(order); t < table.end(order); ++t) {
    if (is_clock(t)) continue;
    std::vector<int> row(columns, 0);
    const auto add = [&](TreeId unknown, int weight) {
      if (const auto found = column.find(unknown); found != column.end()) row[found->second] += weight;
    };
    for (const TreeTable::Split& s : table.splits(t)) {
      if (table.is_node(s.trunk)) add(s.branch, s.count);   // L_c F
      if (table.is_node(s.branch)) add(s.trunk, -s.count);  // L_F c
    }
    if (const auto f = std::ranges::find(free_, t); f != free_.end())
      row[unknowns_.size() + static_cast<std::size_t>(f - free_.begin())] = 1;
    equations_.push_back(t);
    matrix_.push_back(std::move(row));
  }
}

}  // namespace shortfall
