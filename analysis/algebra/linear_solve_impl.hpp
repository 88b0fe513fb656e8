// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The body of linear_solve.hpp, which includes it.

#include <cstddef>
#include <string>

#include "analysis/algebra/error.hpp"

namespace shortfall {
namespace linear_solve_detail {

/// How unwelcome a pivot is: what it is divided by spreads through the rows below.
template <class Field>
std::size_t pivot_cost(const Field& value) {
  if constexpr (requires { value.numerator().terms(); })
    return value.is_constant() ? 0 : value.numerator().terms().size() + value.denominator().terms().size();
  else if constexpr (requires { value.digits(); })
    return value.digits();
  else if constexpr (requires { value.is_rational(); })
    return value.is_rational() ? 0 : 1;
  else
    return 0;
}

/// row -= factor * pivot_row, remembered for the certificate.
template <class Field>
struct Elimination {
  std::size_t row;
  std::size_t pivot_row;
  Field factor;
};

}  // namespace linear_solve_detail

template <class Field>
LinearSolution<Field> solve_linear(const std::vector<std::vector<Field>>& a, const std::vector<Field>& b) {
  using linear_solve_detail::Elimination;
  using linear_solve_detail::pivot_cost;
  const std::size_t rows = a.size();
  const std::size_t columns = a.empty() ? 0 : a.front().size();
  if (b.size() != rows)
    throw Error("a linear system of " + std::to_string(rows) + " rows cannot have " +
                std::to_string(b.size()) + " right-hand sides");
  for (const std::vector<Field>& row : a)
    if (row.size() != columns) throw Error("the rows of a linear system have different lengths");

  std::vector<std::vector<Field>> left = a;
  std::vector<Field> right = b;
  std::vector<Elimination<Field>> done;
  std::vector<bool> used(rows, false);
  struct Pivot {
    std::size_t row, column;
  };
  std::vector<Pivot> pivots;
  LinearSolution<Field> result;

  for (std::size_t column = 0; column < columns; ++column) {
    std::size_t best = rows;
    std::size_t least = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      if (used[row] || left[row][column].is_zero()) continue;
      const std::size_t cost = pivot_cost(left[row][column]);
      if (best < rows && cost >= least) continue;
      best = row;
      least = cost;
    }
    if (best == rows) {
      result.free_unknowns.push_back(static_cast<int>(column));
      continue;
    }
    used[best] = true;
    pivots.push_back({best, column});
    for (std::size_t row = 0; row < rows; ++row) {
      if (used[row] || left[row][column].is_zero()) continue;
      Field factor = left[row][column] / left[best][column];
      left[row][column] = Field(0);
      for (std::size_t k = column + 1; k < columns; ++k)
        if (!left[best][k].is_zero()) left[row][k] -= factor * left[best][k];
      if (!right[best].is_zero()) right[row] -= factor * right[best];
      done.push_back({row, best, std::move(factor)});
    }
  }

  for (std::size_t row = 0; row < rows; ++row) {
    if (used[row] || right[row].is_zero()) continue;
    // This row reads 0 = something else. Undoing the eliminations, last first, tells which sum of given rows
    // it is.
    result.certificate.assign(rows, Field(0));
    result.certificate[row] = Field(1);
    for (std::size_t k = done.size(); k-- > 0;)
      if (!result.certificate[done[k].row].is_zero())
        result.certificate[done[k].pivot_row] -= done[k].factor * result.certificate[done[k].row];
    return result;
  }

  std::vector<Field> solution(columns, Field(0));
  for (std::size_t k = pivots.size(); k-- > 0;) {
    const auto [row, column] = pivots[k];
    Field sum = right[row];
    for (std::size_t j = column + 1; j < columns; ++j)
      if (!left[row][j].is_zero() && !solution[j].is_zero()) sum -= left[row][j] * solution[j];
    solution[column] = sum / left[row][column];
  }
  result.solution = std::move(solution);
  return result;
}

}  // namespace shortfall
