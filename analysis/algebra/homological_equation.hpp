// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "analysis/algebra/lie_quotient.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// [c, A + B] = r, solved for c of degree n - 1 in a quotient of the free Lie algebra.
///
/// Everything depends on the degree alone and is worked out over the rationals once; right-hand sides may
/// have coordinates in any field that contains them.
class HomologicalEquation {
 public:
  /// throws  Unable  when n is not from 2 to 12
  static const HomologicalEquation& of(VectorFields kind, int n);

  int degree() const { return n_; }
  /// Whole numbers y with y . [c, A + B] = 0 for every c; r has a solution if and only if all y . r = 0.
  ///
  /// shape   rows in the coordinates of the quotient's degree n, independent, reduced
  std::span<const std::vector<Rational>> obstructions() const { return obstructions_; }
  /// How many c solve it with r = 0: only c proportional to A + B, in degree 1.
  int kernel_dimension() const { return kernel_dimension_; }

  /// The solution, when there is one: in degree 1 the one without A.
  ///
  /// shape   r and c in the coordinates of the quotient
  template <class Field>
  std::vector<Field> solution(const std::vector<Field>& r) const {
    std::vector<Field> c;
    for (const std::vector<Rational>& row : solve_) c.push_back(product(row, r));
    return c;
  }
  /// The values y . r.
  template <class Field>
  std::vector<Field> residuals(const std::vector<Field>& r) const {
    std::vector<Field> result;
    for (const std::vector<Rational>& row : obstructions_) result.push_back(product(row, r));
    return result;
  }

 private:
  HomologicalEquation(VectorFields kind, int n);
  template <class Field>
  static Field product(const std::vector<Rational>& row, const std::vector<Field>& r) {
    Field sum(0);
    for (std::size_t k = 0; k < r.size(); ++k)
      if (!row[k].is_zero() && !r[k].is_zero()) sum += Field(row[k]) * r[k];
    return sum;
  }

  int n_;
  int kernel_dimension_ = 0;
  std::vector<std::vector<Rational>> solve_;
  std::vector<std::vector<Rational>> obstructions_;
};

}  // namespace shortfall
