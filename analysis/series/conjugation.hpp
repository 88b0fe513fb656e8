// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/tree_series.hpp"

namespace shortfall {

/// exp(ad c) L: the field of the map that first goes along c, then does what L does, then goes back.
template <class K>
TreeSeries<K> conjugated(const TreeTable& table, const TreeSeries<K>& c, TreeSeries<K> field) {
  TreeSeries<K> term = field;
  for (int k = 1; k < table.order(); ++k) {
    term = commutator(table, c, term);
    bool zero = true;
    for (K& value : term) {
      if (vanishes(value)) continue;
      zero = false;
      value /= K(k);
    }
    if (zero) break;
    for (TreeId t = 0; t < table.size(); ++t) field[t] += term[t];
  }
  return field;
}

/// The linear map c -> [c, F] from the trees of one order to those of the next, F the equation itself, and
/// besides it single trees of that order which may be chosen as well.
///
/// Columns: first the trees with function 0 at the root, then the others, then the free ones: what the solver
/// leaves at zero are the later ones.
class Conjugation {
 public:
  Conjugation(const TreeTable& table, int order, std::vector<TreeId> free);

  const std::vector<TreeId>& unknowns() const { return unknowns_; }  ///< trees of order - 1
  const std::vector<TreeId>& free() const { return free_; }          ///< trees of the order itself
  const std::vector<TreeId>& equations() const { return equations_; }
  /// [c, F], one row for each of equations(), whole numbers.
  const std::vector<std::vector<int>>& matrix() const { return matrix_; }

  /// [c, F] + free = right side, or a certificate that there is none.
  ///
  /// shape  right: one entry for each of equations()
  template <class K>
  LinearSolution<K> solved(const std::vector<K>& right) const {
    std::vector<std::vector<K>> matrix;
    for (const std::vector<int>& row : matrix_) {
      matrix.emplace_back();
      for (int entry : row) matrix.back().push_back(K(entry));
    }
    return solve_linear<K>(matrix, right);
  }

 private:
  std::vector<TreeId> unknowns_, free_, equations_;
  std::vector<std::vector<int>> matrix_;
};

}  // namespace shortfall
