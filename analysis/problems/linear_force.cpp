// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/linear_force.hpp"

#include "analysis/problems/functions.hpp"

namespace shortfall {

LinearForm LinearForce::acceleration(const LinearForm& x, const LinearForm& v, const Fraction& t) const {
  LinearForm result;
  Fraction power = 1;
  for (int d = 0; d <= degree; ++d) {
    result.at(force_column(d)) = power;
    if (d < degree) power *= t;
  }
  if (!stiffness.is_zero()) result -= stiffness * x;
  if (!damping.is_zero()) result -= damping * v;
  return result;
}

Fraction LinearForce::function(Function f, const Fraction& a, const Fraction& b) const {
  if (extras) return extras->function(f, a, b);
  if (a.is_constant() && b.is_constant()) return value_of(f, a.constant(), b.constant());
  throw Unable("the step calls " + std::string(name_of(f)) + " of what is no number");
}

Fraction LinearForce::root(const RealRoot& root, const std::string& name) const {
  if (extras) return extras->root(root, name);
  if (root.is_rational()) return root.rational();
  throw Unable("the coefficient '" + name + "' of the step is irrational");
}

void LinearForce::assume(Fraction positive, std::string text) const {
  if (extras) extras->assume(std::move(positive), std::move(text));
}

std::vector<LinearForm> LinearForce::eliminated(std::vector<LinearForm> values) const {
  const int count = static_cast<int>(values.size());
  // values_i = sum_j C_ij u_j + rest_i; Gauss-Jordan on (1 - C) u = rest.
  std::vector<std::vector<Fraction>> matrix(count, std::vector<Fraction>(count));
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      matrix[i][j] = Fraction(i == j ? 1 : 0) - values[i][unknown_column(j)];
      if (unknown_column(j) < values[i].columns()) values[i].at(unknown_column(j)) = 0;
    }
  for (int p = 0; p < count; ++p) {
    int row = p;
    while (row < count && matrix[row][p].is_zero()) ++row;
    if (row == count)
      throw Undefined("an implicit stage has no unique solution: its linear system is singular");
    std::swap(matrix[row], matrix[p]);
    std::swap(values[row], values[p]);
    const Fraction pivot = matrix[p][p];
    if (!(pivot == Fraction(1))) {
      for (Fraction& entry : matrix[p]) entry /= pivot;
      values[p] = values[p] / pivot;
    }
    for (int i = 0; i < count; ++i) {
      if (i == p || matrix[i][p].is_zero()) continue;
      const Fraction factor = matrix[i][p];
      for (int j = p; j < count; ++j) matrix[i][j] -= factor * matrix[p][j];
      values[i] -= factor * values[p];
    }
  }
  return values;
}

}  // namespace shortfall
