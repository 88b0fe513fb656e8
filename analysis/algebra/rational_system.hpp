// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A linear system A x = r with rational A, eliminated once, for right-hand sides over any field that
/// contains the rational numbers.
class RationalSystem {
 public:
  /// shape  rows of equal length; `unknowns` tells how long where there are no rows
  RationalSystem(const std::vector<std::vector<Rational>>& rows, std::size_t unknowns);

  /// Whole numbers y, without a common factor, with y A = 0: r has a solution if and only if all y . r = 0.
  ///
  /// shape   independent rows, reduced
  std::span<const std::vector<Rational>> obstructions() const { return obstructions_; }
  /// The dimension of the solutions of A x = 0. Free unknowns are the first ones that can be, and are set to
  /// 0.
  int kernel_dimension() const { return kernel_dimension_; }

  /// A solution, when there is one.
  template <class Field>
  std::vector<Field> solution(const std::vector<Field>& r) const {
    return products(solve_, r);
  }
  /// The values y . r.
  template <class Field>
  std::vector<Field> residuals(const std::vector<Field>& r) const {
    return products(obstructions_, r);
  }

 private:
  template <class Field>
  static std::vector<Field> products(const std::vector<std::vector<Rational>>& rows,
                                     const std::vector<Field>& r) {
    std::vector<Field> result;
    for (const std::vector<Rational>& row : rows) {
      Field sum(0);
      for (std::size_t k = 0; k < r.size(); ++k)
        if (!row[k].is_zero() && !r[k].is_zero()) sum += Field(row[k]) * r[k];
      result.push_back(sum);
    }
    return result;
  }

  std::vector<std::vector<Rational>> solve_;  ///< x = solve_ r
  std::vector<std::vector<Rational>> obstructions_;
  int kernel_dimension_ = 0;
};

}  // namespace shortfall
