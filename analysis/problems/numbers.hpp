// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/problems/functions.hpp"

namespace shortfall {

/// How a rational becomes a number of type T: one correct rounding, none for Rational and Surd. Numbers whose
/// precision is chosen at run time have no rounding of their own: it must be given.
template <class T>
std::function<T(const Rational&)> usual_rounding() {
  if constexpr (std::is_same_v<T, float>)
    return [](const Rational& value) { return value.to_float(); };
  else if constexpr (std::is_same_v<T, double>)
    return [](const Rational& value) { return value.to_double(); };
  else if constexpr (std::is_constructible_v<T, const Rational&>)
    return [](const Rational& value) { return T(value); };
  else
    return {};
}

/// One body on a line, in numbers of any kind: a trajectory.
///
/// T is a floating-point type, or an exact one (Rational, Surd); position, velocity and time are all T.
template <class T>
struct Numbers {
  using Scalar = T;
  using Vector = T;

  std::function<T(const T& x, const T& v, const T& t)> force;
  std::function<T(const Rational&)> round = usual_rounding<T>();
  int root_digits = 120;  ///< decimal digits of an irrational root before it is rounded to T

  Scalar number(const Rational& value) const { return round(value); }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return round(0); }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const { return force(x, v, t); }

  /// throws  Unable  when the value is no number of an exact kind
  Scalar function(Function f, const Scalar& a, const Scalar& b) const { return value_of(f, a, b); }

  /// throws  Unable  when it is no number of an exact kind
  Scalar root(const RealRoot& root, const std::string&) const {
    if (root.is_rational()) return round(root.rational());
    if constexpr (std::is_same_v<T, Surd>)
      if (root.degree() == 2) return quadratic(root);
    if constexpr (kExact)
      throw Unable("the integrator's coefficient " + root.significant(10) +
                   "... is irrational: it has no value in exact numbers of this kind");
    return round(near(root, root_digits));
  }

  bool longer(const Vector& measured, const Scalar& size_limit, bool) const {
    return size_limit < size(measured);
  }
  Vector shortened(const Vector& v, const Vector& measured, const Scalar& size_limit) const {
    return size_limit / size(measured) * v;
  }

  /// Newton's iteration with the differences of f as its Jacobian, which are exact for a force that is affine
  /// in x and v: then one round solves a stage, and in exact arithmetic nothing else is accepted. Numbers
  /// that round go on until the residual no longer shrinks.
  ///
  /// throws  Undefined  when the stage is singular;  Unable  when the force is not affine and T is exact
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    for (int round = 0; round < (kExact ? 1 : 50); ++round) {
      const std::vector<T> at = f(unknowns);
      const std::vector<std::vector<T>> matrix = one_minus_slopes(unknowns, at, f);
      std::vector<T> residual;
      for (std::size_t i = 0; i < at.size(); ++i) residual.push_back(at[i] - unknowns[i]);
      const std::vector<T> move = solved(matrix, residual);
      std::vector<T> next = unknowns;
      for (std::size_t i = 0; i < at.size(); ++i) next[i] = next[i] + move[i];
      if constexpr (kExact) {
        unknowns = std::move(next);
        if (f(unknowns) != unknowns)
          throw Unable(
              "the force is not affine in x and v: an implicit stage has no exact solution of this kind");
      } else {
        if (round > 0 && !(distance(next, f(next)) < distance(unknowns, at))) return;
        unknowns = std::move(next);
      }
    }
  }

 private:
  /// A root of x^2 + p x + q.
  static Surd quadratic(const RealRoot& root) {
    const Rational lead = root.polynomial()[2];
    const Rational p = root.polynomial()[1] / lead, q = root.polynomial()[0] / lead;
    const Rational middle = -p / Rational(2);
    const Surd radius = Surd::sqrt(middle * middle - q);
    return root.compare(middle) > 0 ? Surd(middle) + radius : Surd(middle) - radius;
  }

  static constexpr bool kExact = std::is_same_v<T, Rational> || std::is_same_v<T, Surd>;

  /// The matrix of 1 - f', column by column.
  template <class F>
  std::vector<std::vector<T>> one_minus_slopes(const std::vector<T>& unknowns, const std::vector<T>& at,
                                               F&& f) const {
    const std::size_t count = unknowns.size();
    std::vector<std::vector<T>> matrix(count, std::vector<T>(count, number(0)));
    for (std::size_t j = 0; j < count; ++j) {
      std::vector<T> moved = unknowns;
      moved[j] = moved[j] + number(1);
      const T width = moved[j] - unknowns[j];
      const std::vector<T> there = f(moved);
      for (std::size_t i = 0; i < count; ++i)
        matrix[i][j] = number(i == j ? 1 : 0) - (there[i] - at[i]) / width;
    }
    return matrix;
  }

  std::vector<T> solved(std::vector<std::vector<T>> matrix, std::vector<T> right) const {
    const Undefined singular("an implicit stage has no unique solution: its linear system is singular");
    if constexpr (kExact) {
      const auto found = solve_linear<T>(matrix, right);
      if (!found.solution || !found.free_unknowns.empty()) throw singular;
      return *found.solution;
    } else {
      // Elimination with the largest pivot of each column.
      const std::size_t count = right.size();
      for (std::size_t p = 0; p < count; ++p) {
        std::size_t best = p;
        for (std::size_t row = p + 1; row < count; ++row)
          if (size(matrix[best][p]) < size(matrix[row][p])) best = row;
        if (matrix[best][p] == number(0)) throw singular;
        std::swap(matrix[best], matrix[p]);
        std::swap(right[best], right[p]);
        for (std::size_t row = 0; row < count; ++row) {
          if (row == p) continue;
          const T factor = matrix[row][p] / matrix[p][p];
          for (std::size_t k = p; k < count; ++k) matrix[row][k] = matrix[row][k] - factor * matrix[p][k];
          right[row] = right[row] - factor * right[p];
        }
      }
      for (std::size_t p = 0; p < count; ++p) right[p] = right[p] / matrix[p][p];
      return right;
    }
  }

  T size(const T& value) const { return value < number(0) ? T(-value) : value; }

  T distance(const std::vector<T>& a, const std::vector<T>& b) const {
    T largest = number(0);
    for (std::size_t i = 0; i < a.size(); ++i)
      if (const T d = size(a[i] - b[i]); largest < d) largest = d;
    return largest;
  }
};

}  // namespace shortfall
