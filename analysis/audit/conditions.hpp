// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/algebra/trees.hpp"
#include "analysis/audit/method.hpp"

namespace shortfall {

/// What is asked of a tableau, so far as it is a polynomial in its entries.
struct Demands {
  int order = 0;  ///< 0: nothing
  int embedded_order = 0;
  int stage_order = 0;
  bool row_sums = true;  ///< c = A 1 (Runge-Kutta only)
  bool symplectic = false;
  bool symmetric = false;
};

/// One equation that a tableau has to satisfy.
struct Condition {
  enum class Kind { row_sum, order, embedded_order, stage_order, symplectic, symmetric };
  Kind kind = Kind::order;
  int order = 0;      ///< of the tree; of stage orders the power of c
  TreeId tree = -1;   ///< order conditions
  std::size_t i = 0;  ///< the stage, of the others
  std::size_t j = 0;
};

/// The equations of a list of demands.
///
/// Order conditions are those of autonomous equations y' = f(y): with c = A 1 they are those of y' = f(y, t)
/// as well. For Nystroem tableaus: those of x'' = a(x, t), of position and velocity.
///
/// source  Butcher (1963); Hairer, Norsett & Wanner (1993), II.2, II.7 (7.14), II.14; Sanz-Serna (1988)
class Conditions {
 public:
  /// throws  Unable  when the trees would need more than `most_bytes`
  Conditions(const Demands& demands, std::size_t stages, bool nystroem, double most_bytes);

  const std::vector<Condition>& list() const { return list_; }
  const TreeTable& trees() const { return *trees_; }

  /// Left side minus right side of each condition.
  template <class K>
  std::vector<K> defects(const Method<K>& m) const;

 private:
  Demands demands_;
  std::vector<Condition> list_;
  std::shared_ptr<const TreeTable> trees_;
  std::vector<Rational> exact_;  ///< 1/gamma, by tree
};

/// The elementary weights of the stages: entry [t][i] belongs to tree t with the force (f or a) at its root,
/// at stage i, before it is multiplied by the step.
template <class K>
std::vector<std::vector<K>> stage_derivatives(const Method<K>& m, const TreeTable& trees);

/// The weights of a result: by tree, for trees with the force at the root those of `weights`; with the drift
/// at the root (Nystroem) those of `position`.
template <class K>
std::vector<K> result_weights(const Method<K>& m, const TreeTable& trees,
                              const std::vector<std::vector<K>>& derivatives, const std::vector<K>& weights,
                              const std::vector<K>& position);

}  // namespace shortfall
