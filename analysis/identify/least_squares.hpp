// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace shortfall {

/// Rows of a linear system that has more rows than unknowns, and their right sides.
struct LinearRows {
  std::size_t unknowns = 0;
  std::vector<double> matrix;  ///< row after row
  std::vector<double> right;

  std::size_t rows() const { return right.size(); }
  void add(const std::vector<double>& row, double value);
};

struct LeastSquares {
  std::vector<double> unknowns;
  std::vector<double> variance;  ///< of each, for rows of variance 1; infinite where the rows do not say it
  std::vector<double> residual;
};

/// The unknowns with the least sum of squares; those that the rows do not say are 0.
///
/// param   weights  of the rows; all 1 when empty
LeastSquares least_squares(const LinearRows& rows, const std::vector<double>& weights = {});

/// The unknowns with the least largest residual, nearly: Lawson's reweighting of least squares.
///
/// source  Lawson (1961), Contributions to the theory of linear least maximum approximations
LeastSquares least_maximum(const LinearRows& rows, int rounds);

}  // namespace shortfall
