// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/series/tableau_series.hpp"

namespace shortfall {

/// One step of a Runge-Kutta method that is given another field instead of f: sum of b(t)/sigma(t) F(t).
/// Tree by tree in the order of ids, so that the field may still be in the making.
///
/// Each stage is a map near the identity; the field behind it is the field transported along its logarithm.
template <class K>
class TableauOfField {
 public:
  TableauOfField(const ButcherTableau<K>& tableau, const TreeTable& table)
      : tableau_(tableau), table_(table), stages_(tableau.stages(), Stage(table)) {}

  /// What the result has at t besides (sum of b_i) field(t).
  K rest(TreeId t) {
    K sum(0);
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      slopes_[i] = stages_[i].field.transport(t, stages_[i].logarithm);
      sum += tableau_.b[i] * slopes_[i];
    }
    return sum;
  }
  /// The field at t, once it is known.
  void settle(TreeId t, const K& field) {
    for (std::size_t j = 0; j < stages_.size(); ++j) {
      slopes_[j] += field;
      stages_[j].field.settle(t, field);
    }
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      Stage& stage = stages_[i];
      K map(0);
      for (std::size_t j = 0; j < stages_.size(); ++j)
        if (!vanishes(tableau_.a[i][j])) map += tableau_.a[i][j] * slopes_[j];
      stage.logarithm[t] = map - stage.flow.flow(t, stage.logarithm);
      stage.flow.settle(t, stage.logarithm[t]);
    }
  }

 private:
  struct Stage {
    explicit Stage(const TreeTable& table) : logarithm(table.size(), K(0)), flow(table), field(table) {}
    TreeSeries<K> logarithm;  ///< of the map from y to the stage
    LieIteration<K> flow;
    LieIteration<K> field;
  };
  const ButcherTableau<K>& tableau_;
  const TreeTable& table_;
  std::vector<Stage> stages_;
  std::vector<K> slopes_ = std::vector<K>(tableau_.stages(), K(0));
};

/// The field with which the method's step is the exact flow of f, for a consistent tableau.
template <class K>
TreeSeries<K> modifying_field(const ButcherTableau<K>& tableau, const TreeTable& table) {
  const TreeSeries<K> exact = exact_flow<K>(table);
  TreeSeries<K> field(table.size(), K(0));
  TableauOfField<K> run(tableau, table);
  K weight(0);
  for (const K& b : tableau.b) weight += b;
  for (TreeId t = 0; t < table.size(); ++t) {
    field[t] = (exact[t] - run.rest(t)) / weight;
    run.settle(t, field[t]);
  }
  return field;
}

}  // namespace shortfall
