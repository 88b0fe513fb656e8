// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/trees.hpp"

namespace shortfall {

/// Trees of a mechanical signature with the force at the root that are one free tree, seen from different
/// roots. A scalar such as V''(v, V') belongs to a free tree.
///
/// Source: Hairer, Lubich & Wanner (2006), IX.9.3.
class FreeTrees {
 public:
  static constexpr int kForce = 0, kDrift = 1;  ///< functions of Signature::mechanical

  /// Of one order.
  FreeTrees(const TreeTable& table, int order);

  /// The smallest root of the same free tree.
  TreeId representative(TreeId t);
  /// The same tree with the root moved over a drift node to the next force.
  std::vector<TreeId> neighbours(TreeId t) const;

 private:
  void join(TreeId a, TreeId b);
  const TreeTable& table_;
  TreeId begin_;
  std::vector<TreeId> parent_;
};

/// How many forces a tree has.
int forces_in(const TreeTable& table, TreeId t);

}  // namespace shortfall
