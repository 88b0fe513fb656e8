// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The body of smooth_force.hpp, which includes it.

namespace shortfall {

template <class K>
SmoothForce<K>::SmoothForce(const TreeTable& table)
    : table_(table),
      reads_velocity_(table.signature().slot(0, 1) != nullptr),
      ranks_(table.size(), -1),
      ranks_up_to_(table.order() + 1, 0) {
  if constexpr (std::is_constructible_v<K, const Rational&>)
    round = [](const Rational& value) { return K(value); };
  for (TreeId t = 0; t < table.size(); ++t) {
    if (table.function(t) != 0) continue;
    ranks_[t] = static_cast<std::int32_t>(trees_.size());
    trees_.push_back(t);
    ++ranks_up_to_[table.order(t)];
    if (table.is_node(t)) {
      grafts_.push_back({-1, 0, 0, 0});
      continue;
    }
    const TreeId child = table.right(t);
    const int slot = table.component(child);
    // The child v stands for the velocity itself, v[tau] for the acceleration's differential tau.
    const std::int32_t index = slot == 2              ? 0
                               : slot == 1            ? 2 + ranks_[child]
                               : table.is_node(child) ? 1
                                                      : 2 + ranks_[table.right(child)];
    grafts_.push_back({ranks_[table.left(t)], index, static_cast<std::int8_t>(slot),
                       static_cast<std::int8_t>(table.multiplicity(t))});
  }
  for (std::size_t n = 1; n < ranks_up_to_.size(); ++n) ranks_up_to_[n] += ranks_up_to_[n - 1];
  set_order(table.order());
}

template <class K>
void SmoothForce<K>::check_near(const Vector& x, const Vector& v) const {
  if (!vanishes(x[0] - K(1))) throw Unable("the step evaluates the force at a position that is not near x");
  if ((reads_velocity_ || given) && (!vanishes(v[0]) || !vanishes(v[1] - K(1))))
    throw Unable("the step evaluates the force at a velocity that is not near v");
}

template <class K>
Differentials<K> SmoothForce<K>::acceleration(const Vector& x, const Vector& v, const Scalar& t) const {
  Vector result;
  if (entries_ == 2) return result;
  check_near(x, v);
  if (given) return acceleration_given(x, v, t);
  result.c.assign(entries_, K(0));
  for (std::size_t r = 0; r + 2 < entries_; ++r) {
    const Graft& g = grafts_[r];
    if (g.left < 0) {
      result.c[2 + r] = K(1);
      continue;
    }
    const K& rest = result.c[2 + static_cast<std::size_t>(g.left)];
    if (vanishes(rest)) continue;
    const K& child = g.slot == 0 ? x[g.index] : g.slot == 1 ? v[g.index] : t;
    if (vanishes(child)) continue;
    result.c[2 + r] = rest * child;
    if (g.multiplicity > 1) result.c[2 + r] /= K(static_cast<int>(g.multiplicity));
  }
  return result;
}

/// What the map from (x, v, t) to the arguments of the force has at a tree.
template <class K>
K SmoothForce<K>::argument(TreeId tree, const Vector& x, const Vector& v, const Scalar& t) const {
  if (table_.function(tree) == 2) return t;
  if (table_.function(tree) == 0) return round(table_.symmetry(tree)) * v[2 + rank(tree)];
  if (table_.is_node(tree)) return x[1];
  return round(table_.symmetry(table_.right(tree))) * x[2 + rank(table_.right(tree))];
}

/// The place of evaluation is a map near the identity; the force there is the force transported along its
/// logarithm.
template <class K>
Differentials<K> SmoothForce<K>::acceleration_given(const Vector& x, const Vector& v, const Scalar& t) const {
  Vector result;
  result.c.assign(entries_, K(0));
  TreeSeries<K> logarithm(table_.size(), K(0));
  LieIteration<K> flow(table_), force(table_);
  for (TreeId tree = 0; tree < table_.end(order_); ++tree) {
    const K map = argument(tree, x, v, t);
    if (table_.function(tree) == 0) {
      K value = (*given)[tree] + force.transport(tree, logarithm);
      force.settle(tree, (*given)[tree]);
      if (!vanishes(value)) result.c[2 + rank(tree)] = value / round(table_.symmetry(tree));
    } else {
      force.transport(tree, logarithm);
    }
    logarithm[tree] = map - flow.flow(tree, logarithm);
    flow.settle(tree, logarithm[tree]);
  }
  return result;
}

template <class K>
std::vector<std::vector<K>> inverse_of(std::vector<std::vector<K>> matrix) {
  const std::size_t n = matrix.size();
  std::vector<std::vector<K>> result(n, std::vector<K>(n, K(0)));
  for (std::size_t i = 0; i < n; ++i) result[i][i] = K(1);
  for (std::size_t p = 0; p < n; ++p) {
    std::size_t row = p;
    if constexpr (requires(const K& k) { abs(k) < abs(k); }) {  // numbers that round: the largest pivot
      for (std::size_t i = p + 1; i < n; ++i)
        if (abs(matrix[row][p]) < abs(matrix[i][p])) row = i;
    } else {
      while (row < n && vanishes(matrix[row][p])) ++row;
    }
    if (row == n || vanishes(matrix[row][p])) throw Undefined("a linear system is singular");
    std::swap(matrix[row], matrix[p]);
    std::swap(result[row], result[p]);
    const K pivot = matrix[p][p];
    for (std::size_t j = 0; j < n; ++j) {
      matrix[p][j] /= pivot;
      result[p][j] /= pivot;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (i == p || vanishes(matrix[i][p])) continue;
      const K factor = matrix[i][p];
      for (std::size_t j = 0; j < n; ++j) {
        matrix[i][j] -= factor * matrix[p][j];
        result[i][j] -= factor * result[p][j];
      }
    }
  }
  return result;
}

template <class K>
template <class F>
void SmoothForce<K>::solve(std::vector<Vector>& unknowns, F&& f) const {
  const std::size_t count = unknowns.size();
  // Forces do not see an entry behind those of the trees: what happens to it is the linear part.
  std::vector<std::vector<K>> rest(count, std::vector<K>(count, K(0)));
  for (std::size_t j = 0; j < count; ++j) {
    std::vector<Vector> probe = unknowns;
    probe[j].at(free_entry_) = K(1);
    const std::vector<Vector> response = f(probe);
    for (std::size_t i = 0; i < count; ++i) rest[i][j] = K(i == j ? 1 : 0) - response[i][free_entry_];
  }
  std::vector<std::vector<K>> step;
  try {
    step = inverse_of(std::move(rest));
  } catch (const Undefined&) {
    throw Undefined("an implicit stage has no unique solution: its linear system is singular");
  }
  // x and v are settled in the first pass, then one order in each.
  for (int pass = 0; pass <= table_.order() + 1; ++pass) {
    const std::vector<Vector> values = f(unknowns);
    bool settled = true;
    std::vector<Vector> moved = unknowns;
    for (std::size_t j = 0; j < count; ++j) {
      const Vector residual = values[j] - unknowns[j];
      for (const K& k : residual.c) settled = settled && vanishes(k);
      for (std::size_t i = 0; i < count; ++i)
        if (!vanishes(step[i][j])) moved[i] += step[i][j] * residual;
    }
    if (settled) return;
    unknowns = std::move(moved);
  }
}

}  // namespace shortfall
