// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/free_trees.hpp"

#include <algorithm>
#include <numeric>

namespace shortfall {

FreeTrees::FreeTrees(const TreeTable& table, int order) : table_(table), begin_(table.begin(order)) {
  parent_.resize(static_cast<std::size_t>(table.end(order) - begin_));
  std::iota(parent_.begin(), parent_.end(), begin_);
  for (TreeId t = begin_; t < table.end(order); ++t)
    if (table.function(t) == FreeTrees::kForce)
      for (TreeId other : neighbours(t)) join(t, other);
}

TreeId FreeTrees::representative(TreeId t) {
  TreeId& p = parent_[static_cast<std::size_t>(t - begin_)];
  return p == t ? t : p = representative(p);
}

std::vector<TreeId> FreeTrees::neighbours(TreeId t) const {
  std::vector<TreeId> result;
  const std::vector<TreeId> children = table_.children(t);
  for (std::size_t i = 0; i < children.size(); ++i) {
    if (table_.function(children[i]) != FreeTrees::kDrift || table_.is_node(children[i])) continue;
    if (i > 0 && children[i] == children[i - 1]) continue;
    // What remains at the old root hangs from the new one.
    TreeId rest = table_.node(FreeTrees::kForce);
    for (std::size_t j = children.size(); j-- > 0;)
      if (j != i) rest = table_.product(rest, children[j]);
    result.push_back(
        table_.product(table_.right(children[i]), table_.product(table_.node(FreeTrees::kDrift), rest)));
  }
  return result;
}

void FreeTrees::join(TreeId a, TreeId b) {
  a = representative(a);
  b = representative(b);
  parent_[static_cast<std::size_t>(std::max(a, b) - begin_)] = std::min(a, b);
}

int forces_in(const TreeTable& table, TreeId t) {
  int count = table.function(t) == FreeTrees::kForce ? 1 : 0;
  for (TreeId c : table.children(t)) count += forces_in(table, c);
  return count;
}

}  // namespace shortfall
