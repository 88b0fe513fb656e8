// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/conditions.hpp"

#include <algorithm>

#include "analysis/series/known_digits.hpp"

namespace shortfall {

namespace {

Signature signature(bool nystroem) {
  return nystroem ? Signature::mechanical(false, true) : Signature::first_order();
}

template <class K>
bool is_exact_zero(const K& value) {
  return value.is_zero();
}

/// sum of row[j] g[j]
template <class K>
K sum_of_products(const std::vector<K>& row, const std::vector<K>& g) {
  K sum(0);
  for (std::size_t j = 0; j < row.size(); ++j)
    if (!is_exact_zero(row[j]) && !is_exact_zero(g[j])) sum += row[j] * g[j];
  return sum;
}

}  // namespace

template <class K>
std::vector<std::vector<K>> stage_derivatives(const Method<K>& m, const TreeTable& trees) {
  const std::size_t stages = m.stages();
  std::vector<std::vector<K>> g(trees.size()), stage(trees.size());
  for (TreeId t = 0; t < trees.size(); ++t) {
    // What the stage shows of this tree: for f or a itself the sum over the row; a drift and the clock show
    // c.
    const bool force = trees.function(t) == 0;
    if (force) {
      g[t].assign(stages, K(1));
      if (!trees.is_node(t)) {
        const std::vector<K>& left = g[trees.left(t)];
        const std::vector<K>& right = stage[trees.right(t)];
        for (std::size_t i = 0; i < stages; ++i) g[t][i] = left[i] * right[i];
      }
    }
    if (trees.order(t) == trees.order()) continue;
    if (!force && trees.is_node(t)) {
      stage[t] = m.c;
      continue;
    }
    if (m.nystroem && force) continue;  // no force reads the velocity
    const std::vector<K>& below = m.nystroem ? g[trees.right(t)] : g[t];
    for (std::size_t i = 0; i < stages; ++i) stage[t].push_back(sum_of_products(m.a[i], below));
  }
  return g;
}

template <class K>
std::vector<K> result_weights(const Method<K>& m, const TreeTable& trees,
                              const std::vector<std::vector<K>>& derivatives, const std::vector<K>& weights,
                              const std::vector<K>& position) {
  std::vector<K> result(trees.size(), K(1));
  for (TreeId t = 0; t < trees.size(); ++t) {
    if (trees.function(t) == 0)
      result[t] = sum_of_products(weights, derivatives[t]);
    else if (m.nystroem && !trees.is_node(t))
      result[t] = sum_of_products(position, derivatives[trees.right(t)]);
  }
  return result;
}

Conditions::Conditions(const Demands& demands, std::size_t stages, bool nystroem, double most_bytes)
    : demands_(demands) {
  const int highest = std::max({demands.order, demands.embedded_order, 1});
  trees_ = std::make_shared<TreeTable>(signature(nystroem), highest, most_bytes);
  for (TreeId t = 0; t < trees_->size(); ++t) exact_.push_back(Rational(1) / trees_->density(t));
  using Kind = Condition::Kind;
  if (demands.row_sums && !nystroem)
    for (std::size_t i = 0; i < stages; ++i) list_.push_back({Kind::row_sum, 1, -1, i, 0});
  const auto trees = [&](Kind kind, int order) {
    for (TreeId t = 0; order > 0 && t < trees_->end(order); ++t)
      if (trees_->function(t) == 0 || (nystroem && !trees_->is_node(t)))
        list_.push_back({kind, trees_->order(t), t, 0, 0});
  };
  trees(Kind::order, demands.order);
  trees(Kind::embedded_order, demands.embedded_order);
  for (int k = nystroem ? 2 : 1; k <= demands.stage_order; ++k)
    for (std::size_t i = 0; i < stages; ++i) list_.push_back({Kind::stage_order, k, -1, i, 0});
  for (std::size_t i = 0; i < stages; ++i)
    for (std::size_t j = 0; j < stages; ++j) {
      if (demands.symplectic && (j <= i || nystroem)) list_.push_back({Kind::symplectic, 2, -1, i, j});
      if (demands.symmetric) list_.push_back({Kind::symmetric, 2, -1, i, j});
    }
  // Weights, times and weights of the position lie behind the columns of the matrix.
  if (demands.symmetric)
    for (std::size_t i = 0; i < stages; ++i)
      for (std::size_t j = stages; j < stages + (nystroem ? 3 : 2); ++j)
        list_.push_back({Kind::symmetric, 1, -1, i, j});
}

template <class K>
std::vector<K> Conditions::defects(const Method<K>& m) const {
  using Kind = Condition::Kind;
  const std::size_t stages = m.stages();
  std::vector<K> result;
  result.reserve(list_.size());
  std::vector<K> of_order, of_embedded;
  if (demands_.order > 0 || demands_.embedded_order > 0) {
    const auto g = stage_derivatives(m, *trees_);
    of_order = result_weights(m, *trees_, g, m.b, m.b_position);
    if (demands_.embedded_order > 0)
      of_embedded = result_weights(m, *trees_, g, m.embedded, m.embedded_position);
  }
  const auto power = [&](std::size_t i, int k) {
    K p(1);
    for (int n = 0; n < k; ++n) p *= m.c[i];
    return p;
  };
  for (const Condition& q : list_) {
    switch (q.kind) {
      case Kind::row_sum: {
        K sum = K(0) - m.c[q.i];
        for (const K& k : m.a[q.i]) sum += k;
        result.push_back(std::move(sum));
        break;
      }
      case Kind::order:
        result.push_back(of_order[q.tree] - K(exact_[q.tree]));
        break;
      case Kind::embedded_order:
        result.push_back(of_embedded[q.tree] - K(exact_[q.tree]));
        break;
      case Kind::stage_order: {
        // sum of a_ij c_j^(k-1) = c_i^k / k; of a Nystroem tableau sum of abar_ij c_j^(k-2) = c_i^k / (k
        // (k-1))
        const int less = m.nystroem ? 2 : 1, below = m.nystroem ? q.order * (q.order - 1) : q.order;
        K sum = K(0) - power(q.i, q.order) / K(below);
        for (std::size_t j = 0; j < stages; ++j)
          if (!is_exact_zero(m.a[q.i][j])) sum += m.a[q.i][j] * power(j, q.order - less);
        result.push_back(std::move(sum));
        break;
      }
      case Kind::symplectic:
        if (!m.nystroem)
          result.push_back(m.b[q.i] * m.a[q.i][q.j] + m.b[q.j] * m.a[q.j][q.i] - m.b[q.i] * m.b[q.j]);
        else if (q.i == q.j)  // Suris (1989): bbar_i = b_i (1 - c_i), and a symmetric matrix
          result.push_back(m.b_position[q.i] - m.b[q.i] * (K(1) - m.c[q.i]));
        else
          result.push_back(m.b[q.i] * (m.b_position[q.j] - m.a[q.i][q.j]) -
                           m.b[q.j] * (m.b_position[q.i] - m.a[q.j][q.i]));
        break;
      case Kind::symmetric: {
        const std::size_t i = stages - 1 - q.i, j = stages - 1 - q.j;
        if (q.j == stages)
          result.push_back(m.b[i] - m.b[q.i]);
        else if (q.j == stages + 1)
          result.push_back(m.c[i] + m.c[q.i] - K(1));
        else if (q.j == stages + 2)
          result.push_back(m.b_position[i] + m.b_position[q.i] - m.b[q.i]);
        else if (!m.nystroem)
          result.push_back(m.a[i][j] + m.a[q.i][q.j] - m.b[j]);
        else
          result.push_back(m.a[i][j] - m.a[q.i][q.j] + m.b_position[q.j] - m.b[q.j] * (K(1) - m.c[q.i]));
        break;
      }
    }
  }
  return result;
}

#define SHORTFALL_CONDITIONS(K)                                                                     \
  template std::vector<std::vector<K>> stage_derivatives(const Method<K>&, const TreeTable&);       \
  template std::vector<K> result_weights(const Method<K>&, const TreeTable&,                        \
                                         const std::vector<std::vector<K>>&, const std::vector<K>&, \
                                         const std::vector<K>&);                                    \
  template std::vector<K> Conditions::defects(const Method<K>&) const;
SHORTFALL_CONDITIONS(Rational)
SHORTFALL_CONDITIONS(Modular)
SHORTFALL_CONDITIONS(Fraction)
SHORTFALL_CONDITIONS(KnownDigits)
#undef SHORTFALL_CONDITIONS

}  // namespace shortfall
