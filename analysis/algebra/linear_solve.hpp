// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace shortfall {

/// What exact elimination found out about A x = b.
template <class Field>
struct LinearSolution {
  /// One solution, free unknowns set to zero; empty when the system is inconsistent.
  std::optional<std::vector<Field>> solution;
  std::vector<int> free_unknowns;
  /// When inconsistent: multipliers y with y^T A = 0 and y^T b != 0, a certificate that anybody can check
  /// (Fredholm's alternative).
  std::vector<Field> certificate;
};

/// Solves A x = b exactly by elimination over a field (Rational, Fraction, Surd).
///
/// shape   A: rows of equal length; b: one entry per row
template <class Field>
LinearSolution<Field> solve_linear(const std::vector<std::vector<Field>>& a, const std::vector<Field>& b);

}  // namespace shortfall

#include "analysis/algebra/linear_solve_impl.hpp"
