// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/tree_series.hpp"
#include "analysis/problems/extra_letters.hpp"
#include "analysis/problems/functions.hpp"

namespace shortfall {

/// A vector of the tree problem: a combination of the position and the velocity at which all is expanded and
/// of the elementary differentials of the acceleration there. Entry 0 belongs to x, entry 1 to v, entry 2 + r
/// to the tree of rank r, see SmoothForce. The step h is 1: the power of h follows from the order of the
/// tree.
template <class K>
struct Differentials {
  std::vector<K> c;

  const K& operator[](std::size_t i) const {
    static const K zero(0);
    return i < c.size() ? c[i] : zero;
  }
  K& at(std::size_t i) {
    if (i >= c.size()) c.resize(i + 1, K(0));
    return c[i];
  }
  Differentials& operator+=(const Differentials& other) {
    if (c.size() < other.c.size()) c.resize(other.c.size(), K(0));
    for (std::size_t i = 0; i < other.c.size(); ++i)
      if (!vanishes(other.c[i])) c[i] += other.c[i];
    return *this;
  }
  Differentials& operator-=(const Differentials& other) {
    if (c.size() < other.c.size()) c.resize(other.c.size(), K(0));
    for (std::size_t i = 0; i < other.c.size(); ++i)
      if (!vanishes(other.c[i])) c[i] -= other.c[i];
    return *this;
  }
  friend Differentials operator+(Differentials a, const Differentials& b) { return std::move(a += b); }
  friend Differentials operator-(Differentials a, const Differentials& b) { return std::move(a -= b); }
  friend Differentials operator-(Differentials a) {
    for (K& k : a.c)
      if (!vanishes(k)) k = K(0) - k;
    return a;
  }
  friend Differentials operator*(const K& s, Differentials a) {
    for (K& k : a.c)
      if (!vanishes(k)) k *= s;
    return a;
  }
  friend Differentials operator/(Differentials a, const K& s) {
    for (K& k : a.c)
      if (!vanishes(k)) k /= s;
    return a;
  }
};

/// x'' = a(x, v, t) for a force that nobody has chosen: vectors are series of elementary differentials, and
/// evaluating the force is grafting onto the root. One run of a step gives its series for every smooth force.
///
/// Source: Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I, II.14 (Nystroem
/// trees).
template <class K>
class SmoothForce {
 public:
  using Scalar = K;
  using Vector = Differentials<K>;

  std::function<K(const Rational&)> round;         ///< how an exact number becomes a K
  std::shared_ptr<ExtraLetters> extras = nullptr;  ///< for K = Fraction
  int root_digits = 0;                             ///< for numbers that round
  /// Coefficients that stand for others are known to this only: what is smaller is taken for zero where the
  /// step has to be consistent.
  Rational tolerance = 0;
  /// The force that the step is given instead of a: the part with a at the root of this series. Null for a
  /// itself.
  const TreeSeries<K>* given = nullptr;

  /// param   table  of a mechanical signature; it must outlive the problem
  explicit SmoothForce(const TreeTable& table);

  /// Trees of a higher order are left out, from here on.
  void set_order(int order) {
    order_ = order;
    entries_ = 2 + ranks_up_to_[order];
    free_entry_ = entries_;
  }
  /// The force is zero; vectors have so many entries, whatever these mean.
  void set_free(std::size_t entries) {
    entries_ = 2;
    free_entry_ = entries;
  }

  TreeId tree(std::size_t rank) const { return trees_[rank]; }
  std::size_t rank(TreeId t) const { return static_cast<std::size_t>(ranks_[t]); }

  Scalar number(const Rational& value) const { return round(value); }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const;

  /// Lengths have no values here: no `limit` acts, every `when` holds.
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }

  Scalar function(Function f, const Scalar& a, const Scalar& b) const {
    if constexpr (std::is_same_v<K, Fraction>) {
      if (extras) return extras->function(f, a, b);
      if (a.is_constant() && b.is_constant()) return value_of(f, a.constant(), b.constant());
      throw Unable("the step calls " + std::string(name_of(f)) + " of what is no number");
    } else {
      return value_of(f, a, b);
    }
  }
  Scalar root(const RealRoot& root, const std::string& name) const {
    if (root.is_rational()) return round(root.rational());
    if constexpr (std::is_same_v<K, Fraction>)
      if (extras) return extras->root(root, name);
    if (root_digits > 0) return round(near(root, root_digits));
    throw Unable("the coefficient '" + name + "' of the step is irrational");
  }

  /// What is linear in the unknowns is eliminated; the force settles one order a pass.
  ///
  /// throws  Undefined  when the stage has no unique solution
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const;

 private:
  struct Graft {
    std::int32_t left;   ///< rank of the tree without its last child
    std::int32_t index;  ///< entry of the argument that the child is
    std::int8_t slot;    ///< 0: of the position, 1: of the velocity, 2: the time
    std::int8_t multiplicity;
  };

  void check_near(const Vector& x, const Vector& v) const;
  K argument(TreeId tree, const Vector& x, const Vector& v, const Scalar& t) const;
  Vector acceleration_given(const Vector& x, const Vector& v, const Scalar& t) const;

  const TreeTable& table_;
  int order_ = 0;
  bool reads_velocity_;
  std::size_t entries_ = 2;     ///< of a vector
  std::size_t free_entry_ = 2;  ///< one that no vector has
  std::vector<TreeId> trees_;   ///< with a at the root, by rank
  std::vector<std::int32_t> ranks_;
  std::vector<std::size_t> ranks_up_to_;  ///< how many trees there are up to an order
  std::vector<Graft> grafts_;
};

/// The inverse of a matrix.
///
/// throws  Undefined  when it is singular
template <class K>
std::vector<std::vector<K>> inverse_of(std::vector<std::vector<K>> matrix);

}  // namespace shortfall

#include "analysis/problems/smooth_force_impl.hpp"
