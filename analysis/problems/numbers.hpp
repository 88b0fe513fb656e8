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
#include "analysis/problems/stage_solver.hpp"

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
  int root_digits = kRoundedRootDigits;  ///< decimal digits of an irrational root before it is rounded to T

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

  /// Numbers that round: `solve_stages`. In exact arithmetic one round of the same is the solution where the
  /// force is affine in x and v, and nothing else is accepted.
  ///
  /// throws  Undefined  when the stage is singular;  Unable  when the force is not affine and T is exact
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    if constexpr (kExact) {
      const std::vector<T> at = f(unknowns);
      const auto matrix = StageParts<T>::one_minus_slopes(unknowns, at, f, number(0), number(1));
      std::vector<T> residual;
      for (std::size_t i = 0; i < at.size(); ++i) residual.push_back(at[i] - unknowns[i]);
      const auto found = solve_linear<T>(matrix, residual);
      if (!found.solution || !found.free_unknowns.empty()) throw Undefined(kSingularStage);
      for (std::size_t i = 0; i < at.size(); ++i) unknowns[i] = unknowns[i] + (*found.solution)[i];
      if (f(unknowns) != unknowns)
        throw Unable(
            "the force is not affine in x and v: an implicit stage has no exact solution of this kind");
    } else {
      solve_stages(unknowns, f, number(0), number(1));
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

  T size(const T& value) const { return value < number(0) ? T(-value) : value; }
};

}  // namespace shortfall
