// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/signature.hpp"

namespace shortfall {

using TreeId = std::int32_t;

/// All coloured rooted trees of a signature up to an order, interned: equal trees have equal ids, and ids
/// grow with the order (the number of nodes).
///
/// A tree is the Butcher product of `left` and `right`: its largest child `right` hangs from the root of
/// `left`. So every property of a tree follows from two smaller ones.
class TreeTable {
 public:
  /// How much a table of so many orders takes, in bytes, known before it is made.
  static double bytes_needed(const Signature& signature, int order);

  /// throws  Unable  when the trees would need more than `most_bytes`
  TreeTable(Signature signature, int order, double most_bytes = 2e9);

  const Signature& signature() const { return signature_; }
  int order() const { return static_cast<int>(begin_.size()) - 2; }
  TreeId size() const { return static_cast<TreeId>(trees_.size()); }
  /// Ids of the trees of one order are begin(order) .. begin(order + 1) - 1.
  TreeId begin(int order) const { return begin_[order]; }
  TreeId end(int order) const { return begin_[order + 1]; }

  int order(TreeId t) const { return trees_[t].order; }
  int function(TreeId t) const { return trees_[t].function; }
  int component(TreeId t) const { return signature_.functions[trees_[t].function].component; }
  bool is_node(TreeId t) const { return trees_[t].left < 0; }
  TreeId left(TreeId t) const { return trees_[t].left; }               ///< -1 for a single node
  TreeId right(TreeId t) const { return trees_[t].right; }             ///< the largest child
  int multiplicity(TreeId t) const { return trees_[t].multiplicity; }  ///< how often that child occurs
  std::vector<TreeId> children(TreeId t) const;                        ///< the largest first
  /// The single node of a function.
  TreeId node(int function) const { return nodes_[function]; }

  /// The Butcher product: `child` hung from the root of `t`. -1 when the signature has no such tree, or it
  /// is of too high an order.
  TreeId product(TreeId t, TreeId child) const;

  /// The number of automorphisms (Hairer, Lubich & Wanner 2006, III.1.3).
  Rational symmetry(TreeId t) const;
  /// The density gamma: the order times the densities of the children.
  Rational density(TreeId t) const;

  /// An edge cut: what remains at the root, what falls off, and how many edges give this pair.
  struct Split {
    TreeId trunk;
    TreeId branch;
    std::int32_t count;
  };
  std::span<const Split> splits(TreeId t) const {
    return {splits_.data() + first_split_[t], splits_.data() + first_split_[t + 1]};
  }

  std::size_t bytes() const;

 private:
  struct Tree {
    std::int8_t order;
    std::int8_t function;
    std::int8_t multiplicity;
    TreeId left;
    TreeId right;
  };
  bool admits(TreeId t, TreeId child) const;
  void add_products(int left_order, int right_order);
  void add_splits(int order);
  TreeId find(TreeId left, TreeId right) const;
  void remember(TreeId left, TreeId right, TreeId t);
  void enlarge();

  Signature signature_;
  std::vector<Tree> trees_;
  std::vector<TreeId> begin_;
  std::vector<TreeId> nodes_;
  std::vector<Split> splits_;
  std::vector<std::uint32_t> first_split_;
  std::vector<TreeId> index_;  ///< open addressing, by left and right
};

}  // namespace shortfall
