// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/tree_series.hpp"

namespace shortfall {

/// The coefficients of a Runge-Kutta method. shape  a: stages x stages; b, c, embedded: stages (embedded may
/// be empty)
template <class K>
struct ButcherTableau {
  std::vector<std::vector<K>> a;
  std::vector<K> b;
  std::vector<K> c;
  std::vector<K> embedded;

  std::size_t stages() const { return b.size(); }
};

/// The elementary weights of a tableau: those of its stages, sum over j of a_ij g_j, and of results with any
/// weights. For y' = f(y) and y' = f(y, t). Source: Butcher (1963); Hairer, Norsett & Wanner (1993), II.2.
template <class K>
class ElementaryWeights {
 public:
  ElementaryWeights(const ButcherTableau<K>& tableau, const TreeTable& table)
      : tableau_(tableau), table_(table) {
    const std::size_t stages = tableau.stages();
    derivatives_.assign(table.size(), std::vector<K>(stages, K(0)));
    stages_.assign(table.size(), std::vector<K>(stages, K(0)));
    for (TreeId t = 0; t < table.size(); ++t) {
      if (table.component(t) != 0) {  // the clock: at stage i it shows c_i
        stages_[t] = tableau.c;
        continue;
      }
      std::vector<K>& g = derivatives_[t];
      if (table.is_node(t)) {
        g.assign(stages, K(1));
      } else {
        for (std::size_t i = 0; i < stages; ++i) {
          const K& left = derivatives_[table.left(t)][i];
          if (!vanishes(left)) g[i] = left * stages_[table.right(t)][i];
        }
      }
      if (table.order(t) == table.order()) continue;  // the stage is of no use there
      for (std::size_t i = 0; i < stages; ++i)
        for (std::size_t j = 0; j < stages; ++j)
          if (!vanishes(tableau.a[i][j]) && !vanishes(g[j])) stages_[t][i] += tableau.a[i][j] * g[j];
    }
  }

  /// The series of y + h sum of weights_i f(stage i).
  TreeSeries<K> result(const std::vector<K>& weights) const {
    TreeSeries<K> map(table_.size(), K(0));
    for (TreeId t = 0; t < table_.size(); ++t) {
      if (table_.component(t) != 0) {
        map[t] = K(1);
        continue;
      }
      for (std::size_t i = 0; i < weights.size(); ++i)
        if (!vanishes(weights[i]) && !vanishes(derivatives_[t][i])) map[t] += weights[i] * derivatives_[t][i];
    }
    return map;
  }

  /// Of stage i, without y: entry t is the coefficient of the tree t (not for the highest order).
  const std::vector<K>& stages(TreeId t) const { return stages_[t]; }

 private:
  const ButcherTableau<K>& tableau_;
  const TreeTable& table_;
  std::vector<std::vector<K>> derivatives_;  ///< [tree][stage]
  std::vector<std::vector<K>> stages_;
};

}  // namespace shortfall
