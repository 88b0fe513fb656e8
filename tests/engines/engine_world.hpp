// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/identify/components.hpp"
#include "analysis/problems/functions.hpp"
#include "tests/engines/recording.hpp"

namespace shortfall::engines {

/// One body in space under gravity and one user's force, in an engine's own arithmetic.
template <class S, class C>
struct EngineWorld {
  using Scalar = S;
  using Vector = Components<S, C>;

  const Recording& recording;
  Adding adding;

  Scalar number(const Rational& value) const {
    if constexpr (std::is_same_v<S, float>)
      return value.to_float();
    else
      return value.to_double();
  }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return {}; }

  Vector vector(const Triple& values) const { return Vector({C(values[0]), C(values[1]), C(values[2])}); }

  Vector acceleration(const Vector& x, const Vector&, const Scalar&) const {
    typename Vector::Parts force{};
    for (std::size_t i = 0; i < 3; ++i) force[i] = C(S(user_force(x.parts(), i)) / S(recording.mass));
    return Vector(vector(recording.gravity).parts(), force, adding);
  }

  Scalar function(Function f, Scalar a, Scalar b) const { return value_of(f, a, b); }
  Scalar root(const RealRoot&, const std::string&) const {
    throw Unable("an engine's frame has no irrational coefficients");
  }
  bool longer(const Vector& measured, Scalar size, bool) const { return norm(measured) > size; }
  Vector shortened(const Vector& v, const Vector& measured, Scalar size) const {
    return size / norm(measured) * v;
  }

  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    throw Unable("an engine's frame solves no implicit stage");
  }

 private:
  /// The force in newtons, as the recorder computed it before it handed it over: in binary64.
  double user_force(const typename Vector::Parts& x, std::size_t i) const {
    if (recording.stiffness != 0) return -recording.stiffness * x[i];
    if (recording.attraction == 0) return recording.force[i];
    const double square = double(x[0]) * x[0] + double(x[1]) * x[1] + double(x[2]) * x[2];
    const double distance = std::sqrt(square);
    return -recording.attraction * x[i] / (distance * distance * distance);
  }
};

}  // namespace shortfall::engines
