// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/tree_series.hpp"
#include "analysis/problems/functions.hpp"

namespace shortfall::testing {

/// A polynomial force in the plane, and steps as power series of h: a problem that a step runs in and that
/// knows nothing of trees. Letters: 0, 1 the position, 2, 3 the velocity, 4 the time, 5 the step.
class PlaneForce {
 public:
  static constexpr Letter kTime = 4, kStep = 5;
  using Pair = std::array<Polynomial, 2>;

  struct Scalar {
    Polynomial p;
    friend Scalar operator+(Scalar a, const Scalar& b) { return {std::move(a.p) + b.p}; }
    friend Scalar operator-(Scalar a, const Scalar& b) { return {std::move(a.p) - b.p}; }
    friend Scalar operator-(const Scalar& a) { return {Polynomial(0) - a.p}; }
    friend Scalar operator*(const Scalar& a, const Scalar& b) { return {a.p * b.p}; }
    friend Scalar operator/(const Scalar& a, const Scalar& b) {
      if (b.p.is_zero() || !b.p.is_constant()) throw Unable("a power series is divided by h");
      return {a.p * Polynomial(Rational(1) / b.p.constant())};
    }
  };
  struct Vector {
    Pair c;
    friend Vector operator+(Vector a, const Vector& b) {
      for (int i : {0, 1}) a.c[i] += b.c[i];
      return a;
    }
    friend Vector operator-(Vector a, const Vector& b) {
      for (int i : {0, 1}) a.c[i] -= b.c[i];
      return a;
    }
    friend Vector operator-(const Vector& a) { return Vector{} - a; }
    friend Vector operator*(const Scalar& s, const Vector& a) { return {{s.p * a.c[0], s.p * a.c[1]}}; }
    friend Vector operator/(const Vector& a, const Scalar& s) { return Scalar{Polynomial(1)} / s * a; }
  };

  PlaneForce(Pair a, int order) : a_(std::move(a)), order_(order) {}

  Scalar number(const Rational& value) const { return {Polynomial(value)}; }
  std::optional<Scalar> parameter(int, bool) const { return std::nullopt; }
  Vector zero() const { return {}; }
  bool longer(const Vector&, const Scalar&, bool assumed) const { return assumed; }
  Vector shortened(const Vector& v, const Vector&, const Scalar&) const { return v; }
  Scalar function(Function f, const Scalar& a, const Scalar& b) const {
    return number(value_of(f, a.p.constant(), b.p.constant()));
  }
  Scalar root(const RealRoot& root, const std::string&) const { return number(root.rational()); }

  Vector acceleration(const Vector& x, const Vector& v, const Scalar& t) const {
    const std::array<Polynomial, 5> place{x.c[0], x.c[1], v.c[0], v.c[1], t.p};
    return {{composed(a_[0], place), composed(a_[1], place)}};
  }

  /// Each round settles one more power of h.
  template <class F>
  void solve(std::vector<Vector>& unknowns, F&& f) const {
    for (int round = 0; round < 2 * order_ + 3; ++round) {
      unknowns = f(unknowns);
      for (Vector& u : unknowns)
        for (Polynomial& p : u.c) p = truncated(p);
    }
  }

  Polynomial truncated(const Polynomial& p) const {
    Polynomial result;
    for (const Polynomial::Term& term : p.terms())
      if (term.monomial.exponent(kStep) <= order_) result += product(term);
    return result;
  }
  Vector truncated(const Vector& v) const { return {{truncated(v.c[0]), truncated(v.c[1])}}; }

  static Vector position() { return {{Polynomial::letter(0), Polynomial::letter(1)}}; }
  static Vector velocity() { return {{Polynomial::letter(2), Polynomial::letter(3)}}; }

  /// What a tree of a mechanical signature with this force is, by differentiating polynomials.
  Pair differential(const TreeTable& table, TreeId t) {
    if (const auto found = differentials_.find(t); found != differentials_.end()) return found->second;
    Pair result;
    const std::vector<TreeId> children = table.children(t);
    if (table.function(t) == 1) {
      result = children.empty() ? velocity().c : differential(table, children[0]);
    } else {
      for (int i : {0, 1}) result[i] = contracted(a_[i], table, children, 0);
    }
    return differentials_[t] = result;
  }

 private:
  static Polynomial product(const Polynomial::Term& term) {
    Polynomial p(term.coefficient);
    for (Letter l = 0; l <= kStep; ++l)
      if (const int e = term.monomial.exponent(l); e > 0) p *= Polynomial::letter(l).pow(e);
    return p;
  }

  Polynomial contracted(const Polynomial& p, const TreeTable& table, const std::vector<TreeId>& children,
                        std::size_t from) {
    if (from == children.size()) return p;
    const int slot = table.component(children[from]);
    if (slot == 2) return contracted(p.derivative(kTime), table, children, from + 1);
    const Pair argument = differential(table, children[from]);
    Polynomial total;
    for (int i : {0, 1}) {
      const Polynomial by = p.derivative(2 * slot + i);
      if (!by.is_zero()) total += contracted(by, table, children, from + 1) * argument[i];
    }
    return total;
  }

  Polynomial composed(const Polynomial& p, const std::array<Polynomial, 5>& place) const {
    Polynomial total;
    for (const Polynomial::Term& term : p.terms()) {
      Polynomial value(term.coefficient);
      for (Letter l = 0; l < kStep; ++l)
        for (int k = 0; k < term.monomial.exponent(l); ++k)
          value = truncated(value * place[static_cast<std::size_t>(l)]);
      total += value;
    }
    return truncated(total);
  }

  Pair a_;
  int order_;
  std::map<TreeId, Pair> differentials_;
};

}  // namespace shortfall::testing
