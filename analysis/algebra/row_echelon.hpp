// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A reduced basis of the rows' span: each row is 1 at its pivot, where all others are 0.
struct RowEchelon {
  std::vector<std::vector<Rational>> rows;
  std::vector<int> pivots;  ///< increasing

  int rank() const { return static_cast<int>(rows.size()); }
};

/// Gauss and Jordan's elimination, exactly. Pivots are looked for in the first `columns` columns only; rows
/// that are 0 there are left out.
inline RowEchelon row_echelon(std::vector<std::vector<Rational>> rows, std::size_t columns) {
  RowEchelon result;
  std::size_t done = 0;
  for (std::size_t column = 0; column < columns && done < rows.size(); ++column) {
    std::size_t best = rows.size();
    for (std::size_t r = done; r < rows.size(); ++r)
      if (!rows[r][column].is_zero() &&
          (best == rows.size() || rows[r][column].digits() < rows[best][column].digits()))
        best = r;
    if (best == rows.size()) continue;
    std::swap(rows[done], rows[best]);
    const Rational scale = Rational(1) / rows[done][column];
    for (Rational& entry : rows[done]) entry *= scale;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == done || rows[r][column].is_zero()) continue;
      const Rational factor = rows[r][column];
      for (std::size_t k = column; k < rows[r].size(); ++k)
        if (!rows[done][k].is_zero()) rows[r][k] -= factor * rows[done][k];
    }
    result.pivots.push_back(static_cast<int>(column));
    ++done;
  }
  rows.resize(done);
  result.rows = std::move(rows);
  return result;
}

}  // namespace shortfall
