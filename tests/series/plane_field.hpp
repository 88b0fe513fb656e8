// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "analysis/algebra/polynomial.hpp"
#include "analysis/algebra/tree_series.hpp"

namespace shortfall::testing {

/// A polynomial vector field in the plane, y' = f(y), and what trees and steps make of it, without series of
/// trees: by differentiating polynomials. Letters 0 and 1 are y, letter 2 is h.
class PlaneField {
 public:
  using Vector = std::array<Polynomial, 2>;
  static constexpr Letter kStep = 2;

  PlaneField(Vector f, int order) : f_(std::move(f)), order_(order) {}

  /// The elementary differential of a tree of Signature::first_order().
  const Vector& differential(const TreeTable& table, TreeId t) {
    if (const auto found = differentials_.find(t); found != differentials_.end()) return found->second;
    std::vector<Vector> arguments;
    for (TreeId c : table.children(t)) arguments.push_back(differential(table, c));
    return differentials_[t] = {contracted(f_[0], arguments, 0), contracted(f_[1], arguments, 0)};
  }

  /// The sum of h^|t| c(t)/sigma(t) F(t).
  Vector sum(const TreeTable& table, const TreeSeries<Rational>& series) {
    Vector total;
    for (TreeId t = 0; t < table.size(); ++t) {
      if (series[t].is_zero()) continue;
      const Polynomial weight =
          Polynomial(series[t] / table.symmetry(t)) * Polynomial::letter(kStep).pow(table.order(t));
      for (int i : {0, 1}) total[i] += weight * differential(table, t)[i];
    }
    return total;
  }

  /// f at another place, h^(order + 1) and more left out.
  Vector at(const Vector& place) const { return {composed(f_[0], place), composed(f_[1], place)}; }
  Polynomial truncated(const Polynomial& p) const {
    Polynomial result;
    for (int k = 0; k <= order_; ++k) result += p.coefficient(kStep, k) * Polynomial::letter(kStep).pow(k);
    return result;
  }

  /// The derivative along a field.
  static Polynomial along(const Polynomial& p, const Vector& field) {
    return p.derivative(0) * field[0] + p.derivative(1) * field[1];
  }

 private:
  /// The derivative of p by all of its arguments, the coefficients of the arguments not differentiated.
  static Polynomial contracted(const Polynomial& p, const std::vector<Vector>& arguments, std::size_t from) {
    if (from == arguments.size()) return p;
    Polynomial total;
    for (Letter i : {0, 1})
      total +=
          contracted(p.derivative(i), arguments, from + 1) * arguments[from][static_cast<std::size_t>(i)];
    return total;
  }

  Polynomial composed(const Polynomial& p, const Vector& place) const {
    Polynomial total;
    for (const Polynomial::Term& term : p.terms()) {
      Polynomial product(term.coefficient);
      for (Letter i : {0, 1})
        for (int k = 0; k < term.monomial.exponent(i); ++k)
          product = truncated(product * place[static_cast<std::size_t>(i)]);
      total += product * Polynomial::letter(kStep).pow(term.monomial.exponent(kStep));
    }
    return truncated(total);
  }

  Vector f_;
  int order_;
  std::map<TreeId, Vector> differentials_;
};

}  // namespace shortfall::testing
