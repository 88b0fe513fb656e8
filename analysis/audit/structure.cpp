// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/structure.hpp"

#include "analysis/algebra/tree_series.hpp"
#include "analysis/audit/conditions.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

namespace {

TreeTable trees_for(bool nystroem, int order) {
  return TreeTable(nystroem ? Signature::mechanical(false, true) : Signature::first_order(), order);
}

template <class K>
TreeSeries<K> map_of(const Method<K>& m, const TreeTable& trees) {
  return result_weights(m, trees, stage_derivatives(m, trees), m.b, m.b_position);
}

std::string exact_text(const Rational& value) { return value.str(); }
std::string exact_text(const Fraction& value) {
  return value.is_constant() ? value.constant().str() : "an irrational number";
}

std::string exact_text(const KnownDigits& value) {
  constexpr int kShown = 6;
  return "≈ " + value.ball().midpoint().significant(kShown);
}

}  // namespace

template <class K>
std::optional<std::string> not_symmetric(const Method<K>& m, int order) {
  for (int n = 1; n <= order; ++n) {
    const TreeTable trees = trees_for(m.nystroem, n);
    const TreeSeries<K> map = map_of(m, trees), other = adjoint(trees, map);
    for (TreeId t = trees.begin(n); t < trees.end(n); ++t)
      if (!is_nothing(map[t] - other[t]))
        return differential(trees, t) + ": its weight is " + exact_text(map[t]) + ", that of the adjoint " +
               exact_text(other[t]);
  }
  return std::nullopt;
}

template <class K>
std::optional<std::string> not_symplectic(const Method<K>& m, int order) {
  if (m.nystroem) return std::nullopt;
  for (int n = 2; n <= order; ++n) {
    const TreeTable trees = trees_for(false, n);
    const TreeSeries<K> map = map_of(m, trees);
    for (TreeId u = 0; u < trees.end(n - 1); ++u)
      for (TreeId v = 0; v <= u; ++v) {
        if (trees.order(u) + trees.order(v) != n) continue;
        const TreeId uv = trees.product(u, v), vu = trees.product(v, u);
        const K excess = map[uv] + map[vu] - map[u] * map[v];
        if (!is_nothing(excess))
          return "the trees " + tree_text(trees, uv) + " and " + tree_text(trees, vu) +
                 ": their weights differ from the product by " + exact_text(excess);
      }
  }
  return std::nullopt;
}

template std::optional<std::string> not_symmetric(const Method<Rational>&, int);
template std::optional<std::string> not_symmetric(const Method<Fraction>&, int);
template std::optional<std::string> not_symplectic(const Method<Rational>&, int);
template std::optional<std::string> not_symplectic(const Method<Fraction>&, int);

template std::optional<std::string> not_symmetric(const Method<KnownDigits>&, int);
template std::optional<std::string> not_symplectic(const Method<KnownDigits>&, int);

}  // namespace shortfall
