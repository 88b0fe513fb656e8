// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// How a rational becomes a number of type T: one correct rounding (none for Rational and Surd).
template <class T>
T rounded(const Rational& value) {
  if constexpr (std::is_same_v<T, float>)
    return value.to_float();
  else if constexpr (std::is_same_v<T, double>)
    return value.to_double();
  else
    return T(value);
}

/// One body on a line, in numbers of any kind: a trajectory.
///
/// T is a floating-point type, or an exact one (Rational, Surd); position, velocity and time are all T.
template <class T>
struct Numbers {
  using Scalar = T;
  using Vector = T;

  std::function<T(const T& x, const T& v, const T& t)> force;
  std::function<T(const Rational&)> round = rounded<T>;

  Scalar number(const Rational& value) const { return round(value); }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return round(0); }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const { return force(x, v, t); }

  /// Newton's iteration with the exact Jacobian of an affine stage: f is affine in the unknowns for every force that is affine in x and v, so
  /// that one round solves it; in exact arithmetic nothing else is accepted.
  ///
  /// throws  Undefined  when the stage is singular; NoConvergence-like Unable when the force is not affine and T is exact
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    const std::size_t count = unknowns.size();
    const std::vector<T> at = f(unknowns);
    bool constant = true;
    std::vector<std::vector<T>> matrix(count, std::vector<T>(count));
    for (std::size_t j = 0; j < count; ++j) {
      std::vector<T> moved = unknowns;
      moved[j] = moved[j] + number(1);
      const std::vector<T> there = f(moved);
      for (std::size_t i = 0; i < count; ++i) {
        const T slope = there[i] - at[i];
        if (!(slope == number(0))) constant = false;
        matrix[i][j] = number(i == j ? 1 : 0) - slope;
      }
    }
    if (constant) {
      unknowns = at;
      return;
    }
    std::vector<T> right(count);
    for (std::size_t i = 0; i < count; ++i) right[i] = at[i] - unknowns[i];
    const auto found = solve_linear<T>(matrix, right);
    if (!found.solution || !found.free_unknowns.empty())
      throw Undefined("an implicit stage has no unique solution: its linear system is singular");
    for (std::size_t i = 0; i < count; ++i) unknowns[i] = unknowns[i] + (*found.solution)[i];
    if constexpr (std::is_same_v<T, Rational>)
      if (f(unknowns) != unknowns) throw Unable("the force is not affine in x and v: an implicit stage has no exact rational solution");
  }
};

}  // namespace shortfall
