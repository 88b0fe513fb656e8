// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/function.hpp"

namespace shortfall {

/// A combination of x, v and evaluations of the force: what a step makes when nothing at all is known of the
/// force. Key 0 is x, 1 is v, 2 + j the j-th evaluation of a FreeForce.
struct FreeVector {
  std::map<int, Fraction> terms;  ///< no zero coefficients

  FreeVector& add(const FreeVector& other, const Fraction& factor);
  friend FreeVector operator+(FreeVector a, const FreeVector& b) { return a.add(b, 1); }
  friend FreeVector operator-(FreeVector a, const FreeVector& b) { return a.add(b, -1); }
  friend FreeVector operator-(const FreeVector& a) { return FreeVector().add(a, -1); }
  friend FreeVector operator*(const Fraction& s, const FreeVector& a) { return FreeVector().add(a, s); }
  friend FreeVector operator/(const FreeVector& a, const Fraction& s) {
    return FreeVector().add(a, Fraction(1) / s);
  }
  bool operator==(const FreeVector&) const = default;

  static FreeVector x() { return {{{0, 1}}}; }
  static FreeVector v() { return {{{1, 1}}}; }
};

/// x'' = a(x, t), a being nothing but a name: equal arguments give the same evaluation, different ones have
/// nothing to do with each other. Two steps that agree here agree for every force, smooth or not. A force
/// that reads the velocity is not meant.
class FreeForce {
 public:
  using Scalar = Fraction;
  using Vector = FreeVector;

  Scalar number(const Rational& value) const { return value; }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return {}; }
  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t);

  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }
  /// throws  Unable  for what is no rational number: other problems answer then
  Scalar function(Function f, const Scalar& a, const Scalar& b) const;
  Scalar root(const RealRoot& root, const std::string& name) const;

  /// throws  Unable  always: a stage that is solved for has no formula
  template <class F>
  void solve(std::vector<Vector>&, F&&) const {
    refuse_stage();
  }

 private:
  [[noreturn]] static void refuse_stage();
  struct Evaluation {
    FreeVector x;
    Fraction t;
  };
  std::vector<Evaluation> evaluations_;
};

}  // namespace shortfall
