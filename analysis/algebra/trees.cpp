// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/trees.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr int kHighestOrder = 100;  // orders are kept in a byte; memory ends long before

std::size_t mixed(TreeId left, TreeId right) {
  const std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(left)) << 32) |
                            static_cast<std::uint32_t>(right);
  return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 20);
}

std::string in_megabytes(double bytes) {
  const double megabytes = bytes / 1e6;
  if (megabytes >= 1e9) return "more than 10^9 megabytes";
  return std::to_string(std::llround(megabytes)) + " megabytes";
}

}  // namespace

double TreeTable::bytes_needed(const Signature& signature, int order) {
  double bytes = 0;
  for (std::size_t f = 0; f < signature.functions.size(); ++f) {
    const std::vector<Rational> counts = tree_counts(signature, static_cast<int>(f), order);
    for (int n = 1; n <= order; ++n)
      // The index is at most four times as long as the trees; a tree of order n has fewer than n splits.
      bytes += counts[n].to_double() *
               static_cast<double>(sizeof(Tree) + 4 * sizeof(TreeId) + sizeof(std::uint32_t) +
                                   sizeof(Split) * static_cast<std::size_t>(std::max(1, n - 1)));
  }
  return bytes;
}

TreeTable::TreeTable(Signature signature, int order, double most_bytes) : signature_(std::move(signature)) {
  if (order < 1 || order > kHighestOrder)
    throw Unable("trees are made for the orders 1 to " + std::to_string(kHighestOrder));
  // Low orders fit by themselves; the count of high ones takes longer than the trees of low ones.
  for (int n = std::min(order, 6); n <= order; ++n)
    if (const double bytes = bytes_needed(signature_, n); bytes > most_bytes || bytes > 1e11)
      throw Unable("the trees of order " + std::to_string(n) + " take " + in_megabytes(bytes) + ", and " +
                   in_megabytes(most_bytes) + " are allowed: ask for order " + std::to_string(n - 1) +
                   " or less");
  index_.assign(1024, -1);
  first_split_.push_back(0);
  begin_ = {0, 0};
  for (std::size_t f = 0; f < signature_.functions.size(); ++f) {
    nodes_.push_back(static_cast<TreeId>(f));
    trees_.push_back({1, static_cast<std::int8_t>(f), 0, -1, -1});
    first_split_.push_back(0);
  }
  begin_.push_back(size());
  for (int n = 2; n <= order; ++n) {
    for (int i = 1; i < n; ++i) add_products(i, n - i);
    begin_.push_back(size());
    add_splits(n);
  }
}

bool TreeTable::admits(TreeId t, TreeId child) const {
  const Signature::Slot* slot = signature_.slot(function(t), component(child));
  if (!slot) return false;
  const int most = signature_.functions[function(t)].most;
  if (slot->most == Signature::kAny && most == Signature::kAny) return true;
  int there = 0, all = 0;
  for (TreeId s = t; !is_node(s); s = left(s)) {
    ++all;
    there += component(right(s)) == component(child) ? 1 : 0;
  }
  return there < slot->most && all < most;
}

void TreeTable::add_products(int left_order, int right_order) {
  // begin_ has no entry for the order in the making: the ends are those of finished orders.
  const TreeId left_end = begin_[left_order + 1], right_end = begin_[right_order + 1];
  for (TreeId l = begin_[left_order]; l < left_end; ++l) {
    const TreeId largest = is_node(l) ? -1 : right(l);
    for (TreeId r = std::max(begin_[right_order], largest); r < right_end; ++r) {
      if (!admits(l, r)) continue;
      const int multiplicity = r == largest ? trees_[l].multiplicity + 1 : 1;
      const TreeId id = size();
      trees_.push_back({static_cast<std::int8_t>(left_order + right_order), trees_[l].function,
                        static_cast<std::int8_t>(multiplicity), l, r});
      remember(l, r, id);
    }
  }
}

/// The edges of a tree are those of `left`, those of `right`, and the one between them.
void TreeTable::add_splits(int order) {
  std::vector<Split> found;
  for (TreeId t = begin_[order]; t < begin_[order + 1]; ++t) {
    const TreeId l = left(t), r = right(t);
    found.assign(1, {l, r, 1});
    for (const Split& s : splits(l)) found.push_back({product(s.trunk, r), s.branch, s.count});
    for (const Split& s : splits(r)) found.push_back({product(l, s.trunk), s.branch, s.count});
    std::ranges::sort(found, [](const Split& a, const Split& b) {
      return a.trunk != b.trunk ? a.trunk < b.trunk : a.branch < b.branch;
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool again =
          i > 0 && found[i].trunk == found[i - 1].trunk && found[i].branch == found[i - 1].branch;
      if (again)
        splits_.back().count += found[i].count;
      else
        splits_.push_back(found[i]);
    }
    first_split_.push_back(static_cast<std::uint32_t>(splits_.size()));
  }
}

TreeId TreeTable::find(TreeId left, TreeId right) const {
  const std::size_t mask = index_.size() - 1;
  for (std::size_t i = mixed(left, right) & mask; index_[i] >= 0; i = (i + 1) & mask)
    if (const Tree& t = trees_[index_[i]]; t.left == left && t.right == right) return index_[i];
  return -1;
}

void TreeTable::remember(TreeId left, TreeId right, TreeId t) {
  if (trees_.size() * 2 > index_.size()) enlarge();
  const std::size_t mask = index_.size() - 1;
  std::size_t i = mixed(left, right) & mask;
  while (index_[i] >= 0) i = (i + 1) & mask;
  index_[i] = t;
}

void TreeTable::enlarge() {
  index_.assign(index_.size() * 2, -1);
  const std::size_t mask = index_.size() - 1;
  for (TreeId t = 0; t + 1 < size(); ++t) {  // the last one is not in yet
    if (is_node(t)) continue;
    std::size_t i = mixed(left(t), right(t)) & mask;
    while (index_[i] >= 0) i = (i + 1) & mask;
    index_[i] = t;
  }
}

std::vector<TreeId> TreeTable::children(TreeId t) const {
  std::vector<TreeId> result;
  for (TreeId s = t; !is_node(s); s = left(s)) result.push_back(right(s));
  return result;
}

TreeId TreeTable::product(TreeId t, TreeId child) const {
  if (is_node(t) || child >= right(t)) return find(t, child);
  const TreeId inner = product(left(t), child);
  return inner < 0 ? -1 : find(inner, right(t));
}

Rational TreeTable::symmetry(TreeId t) const {
  if (is_node(t)) return 1;
  return symmetry(left(t)) * symmetry(right(t)) * Rational(multiplicity(t));
}

Rational TreeTable::density(TreeId t) const {
  Rational product(order(t));
  for (TreeId s = t; !is_node(s); s = left(s)) product *= density(right(s));
  return product;
}

std::size_t TreeTable::bytes() const {
  return trees_.capacity() * sizeof(Tree) + index_.capacity() * sizeof(TreeId) +
         splits_.capacity() * sizeof(Split) + first_split_.capacity() * sizeof(std::uint32_t);
}

}  // namespace shortfall
