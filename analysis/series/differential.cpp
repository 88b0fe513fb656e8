// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/differential.hpp"

#include <algorithm>
#include <vector>

namespace shortfall {

namespace {

/// The children of a node, smallest first.
std::vector<TreeId> children_of(const TreeTable& table, TreeId t) {
  std::vector<TreeId> children = table.children(t);
  std::ranges::reverse(children);
  return children;
}

bool has_one_component_of_space(const Signature& s) { return s.components[0] == "y"; }

std::string primes(std::size_t count, bool latex) {
  if (count <= 3) return std::string(count, '\'');
  const std::string order = "(" + std::to_string(count) + ")";
  return latex ? "^{" + order + "}" : "^" + order;
}

/// Which components a node is differentiated by: a_xv.
std::string indices(const TreeTable& table, const std::vector<TreeId>& children, bool latex) {
  std::string letters;
  for (TreeId c : children) letters += table.signature().components[table.component(c)];
  std::ranges::sort(letters, [](char a, char b) {
    const std::string order = "xvqpt";
    return order.find(a) < order.find(b);
  });
  if (letters.empty()) return {};
  return latex ? "_{" + letters + "}" : "_" + letters;
}

}  // namespace

std::string differential(const TreeTable& table, TreeId t, bool latex) {
  const Signature& s = table.signature();
  const Signature::Function& f = s.functions[table.function(t)];
  std::vector<TreeId> children = children_of(table, t);
  // The drift v differentiated by v is the identity.
  if (f.name == "v" && !children.empty()) return differential(table, children[0], latex);
  const bool mechanical = s.components[0] == "x";
  std::string text = f.name;
  if (mechanical) text += indices(table, children, latex);
  // Of the clock, t' = 1, only the index is seen. Arguments in the order of the indices.
  std::erase_if(children, [&](TreeId c) { return s.functions[table.function(c)].name == "1"; });
  if (mechanical)
    std::ranges::stable_sort(children,
                             [&](TreeId a, TreeId b) { return table.component(a) < table.component(b); });
  if (!mechanical) {
    const std::size_t by_time = table.children(t).size() - children.size();
    text += primes(children.size(), latex);
    if (by_time > 0) text += (latex ? "_{" : "_") + std::string(by_time, 't') + (latex ? "}" : "");
  }
  if (children.empty()) return text;
  if (children.size() == 1)
    return text + (has_one_component_of_space(s) && !latex && text.back() != 't' ? "" : " ") +
           differential(table, children[0], latex);
  text += "(";
  for (std::size_t i = 0; i < children.size(); ++i)
    text += (i > 0 ? ", " : "") + differential(table, children[i], latex);
  return text + ")";
}

std::string tree_text(const TreeTable& table, TreeId t) {
  std::string text = table.signature().functions[table.function(t)].name;
  const std::vector<TreeId> children = children_of(table, t);
  if (children.empty()) return text;
  text += "[";
  for (std::size_t i = 0; i < children.size(); ++i)
    text += (i > 0 ? "," : "") + tree_text(table, children[i]);
  return text + "]";
}

}  // namespace shortfall
