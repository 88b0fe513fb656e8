// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/trees.hpp"

namespace shortfall {

/// The coefficients c of a series of elementary differentials, sum of h^|t| c(t)/sigma(t) F(t), by TreeId: a
/// map near the identity (the identity itself left out), or a vector field times h.
///
/// K is a field: Rational, Fraction, Modular, Real. Series are as long as the table.
///
/// Everything below is built from the Lie derivative along a field, which in this normalisation is a sum over
/// the edges of a tree. Source: Hairer, Lubich & Wanner (2006), IX.9.1, Lemma 9.1; Murua (1999), Formal
/// series and numerical integrators.
template <class K>
using TreeSeries = std::vector<K>;

template <class K>
bool vanishes(const K& value) {
  if constexpr (requires { value.is_zero(); })
    return value.is_zero();
  else
    return value == 0;
}

/// The iterated Lie derivatives L^j c / j! of a series along the field b, made tree by tree in the order of
/// ids, so that b and c may still be in the making.
template <class K>
class LieIteration {
 public:
  explicit LieIteration(const TreeTable& table) : table_(table), rows_(table.size()) {}

  /// L^j c / j! at t for j = 1, 2, ..., from b and what is known of smaller trees.
  const std::vector<K>& derivatives(TreeId t, const TreeSeries<K>& b) {
    std::vector<K>& row = rows_[t];
    row.assign(table_.order(t), K(0));
    for (const TreeTable::Split& s : table_.splits(t)) {
      if (vanishes(b[s.branch])) continue;
      const K weight = s.count == 1 ? b[s.branch] : K(s.count) * b[s.branch];
      const std::vector<K>& trunk = rows_[s.trunk];
      for (std::size_t j = 0; j < trunk.size(); ++j)
        if (!vanishes(trunk[j])) row[j + 1] += weight * trunk[j];
    }
    for (std::size_t j = 2; j < row.size(); ++j)
      if (!vanishes(row[j])) row[j] /= K(static_cast<int>(j));
    return row;
  }
  /// c(t), once it is known.
  void settle(TreeId t, K value) { rows_[t][0] = std::move(value); }

  /// The sum of L^j c / j! over j >= 1: what exp(L_b) adds to c.
  K transport(TreeId t, const TreeSeries<K>& b) {
    K sum(0);
    const std::vector<K>& row = derivatives(t, b);
    for (std::size_t j = 1; j < row.size(); ++j) sum += row[j];
    return sum;
  }
  /// With c = b: the sum of L^(j-1) b / j! over j >= 2, what the flow of b has besides b.
  K flow(TreeId t, const TreeSeries<K>& b) {
    K sum(0);
    const std::vector<K>& row = derivatives(t, b);
    for (std::size_t j = 1; j < row.size(); ++j)
      if (!vanishes(row[j])) sum += row[j] / K(static_cast<int>(j + 1));
    return sum;
  }

 private:
  const TreeTable& table_;
  std::vector<std::vector<K>> rows_;
};

/// The derivative of c along the field b: sum over edges of c(trunk) b(branch).
template <class K>
TreeSeries<K> lie_derivative(const TreeTable& table, const TreeSeries<K>& b, const TreeSeries<K>& c) {
  TreeSeries<K> result(table.size(), K(0));
  for (TreeId t = 0; t < table.size(); ++t)
    for (const TreeTable::Split& s : table.splits(t))
      if (!vanishes(b[s.branch]) && !vanishes(c[s.trunk])) result[t] += K(s.count) * b[s.branch] * c[s.trunk];
  return result;
}

/// The commutator of two fields, [a, b] = L_a b - L_b a.
template <class K>
TreeSeries<K> commutator(const TreeTable& table, const TreeSeries<K>& a, const TreeSeries<K>& b) {
  TreeSeries<K> result = lie_derivative(table, a, b);
  const TreeSeries<K> other = lie_derivative(table, b, a);
  for (TreeId t = 0; t < table.size(); ++t) result[t] -= other[t];
  return result;
}

/// The flow of a field over the time 1.
template <class K>
TreeSeries<K> exponential(const TreeTable& table, const TreeSeries<K>& b) {
  TreeSeries<K> result(table.size(), K(0));
  LieIteration<K> iteration(table);
  for (TreeId t = 0; t < table.size(); ++t) {
    result[t] = b[t] + iteration.flow(t, b);
    iteration.settle(t, b[t]);
  }
  return result;
}

/// The field whose flow over the time 1 is this map: the modified equation of an integrator.
template <class K>
TreeSeries<K> logarithm(const TreeTable& table, const TreeSeries<K>& map) {
  TreeSeries<K> b(table.size(), K(0));
  LieIteration<K> iteration(table);
  for (TreeId t = 0; t < table.size(); ++t) {
    b[t] = map[t] - iteration.flow(t, b);
    iteration.settle(t, b[t]);
  }
  return b;
}

/// exp(L_b) c: the series c, evaluated behind the flow of b.
template <class K>
TreeSeries<K> transported(const TreeTable& table, const TreeSeries<K>& b, const TreeSeries<K>& c) {
  TreeSeries<K> result(table.size(), K(0));
  LieIteration<K> iteration(table);
  for (TreeId t = 0; t < table.size(); ++t) {
    result[t] = c[t] + iteration.transport(t, b);
    iteration.settle(t, c[t]);
  }
  return result;
}

/// First one map, then the other.
template <class K>
TreeSeries<K> composition(const TreeTable& table, const TreeSeries<K>& first, const TreeSeries<K>& then) {
  TreeSeries<K> result = transported(table, logarithm(table, first), then);
  for (TreeId t = 0; t < table.size(); ++t) result[t] += first[t];
  return result;
}

/// The map that undoes a map.
template <class K>
TreeSeries<K> inverse(const TreeTable& table, const TreeSeries<K>& map) {
  TreeSeries<K> b = logarithm(table, map);
  for (K& value : b) value = K(0) - value;
  return exponential(table, b);
}

/// The map with the step h replaced by -h: every tree of odd order changes its sign.
template <class K>
TreeSeries<K> with_reversed_step(const TreeTable& table, TreeSeries<K> series) {
  for (TreeId t = 0; t < table.size(); ++t)
    if (table.order(t) % 2 == 1) series[t] = K(0) - series[t];
  return series;
}

/// The adjoint of a map: its inverse, with the step reversed (Hairer, Lubich & Wanner 2006, II.3).
template <class K>
TreeSeries<K> adjoint(const TreeTable& table, const TreeSeries<K>& map) {
  return with_reversed_step(table, inverse(table, map));
}

/// The exact flow: 1/gamma (Butcher 1963; Hairer, Lubich & Wanner 2006, III.1.3).
template <class K>
TreeSeries<K> exact_flow(const TreeTable& table) {
  TreeSeries<K> result;
  std::vector<Rational> densities;
  result.reserve(table.size());
  for (TreeId t = 0; t < table.size(); ++t) {
    // Of the node and its children: order / left order, times the right density.
    Rational density(table.order(t));
    if (!table.is_node(t))
      density *= densities[table.left(t)] / Rational(table.order(table.left(t))) * densities[table.right(t)];
    result.push_back(K(1) / K(density));
    densities.push_back(std::move(density));
  }
  return result;
}

/// The equation itself, h f: 1 at single nodes.
template <class K>
TreeSeries<K> the_equation(const TreeTable& table) {
  TreeSeries<K> result(table.size(), K(0));
  for (TreeId t = 0; t < table.size(); ++t)
    if (table.is_node(t)) result[t] = K(1);
  return result;
}

}  // namespace shortfall
