// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "analysis/algebra/univariate.hpp"

namespace shortfall {

/// A square matrix over a field, row by row.
template <class F>
using SquareMatrix = std::vector<std::vector<F>>;

template <class F>
SquareMatrix<F> product(const SquareMatrix<F>& a, const SquareMatrix<F>& b) {
  const std::size_t size = a.size();
  SquareMatrix<F> result(size, std::vector<F>(size, F(0)));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) {
      if (a[i][k].is_zero()) continue;
      for (std::size_t j = 0; j < size; ++j) result[i][j] += a[i][k] * b[k][j];
    }
  return result;
}

template <class F>
bool is_zero(const SquareMatrix<F>& m) {
  return std::ranges::all_of(
      m, [](const auto& row) { return std::ranges::all_of(row, [](const F& f) { return f.is_zero(); }); });
}

/// p(M).
template <class F>
SquareMatrix<F> evaluated(const Univariate<F>& p, const SquareMatrix<F>& m) {
  SquareMatrix<F> result(m.size(), std::vector<F>(m.size(), F(0)));
  for (int k = p.degree(); k >= 0; --k) {
    result = product(result, m);
    for (std::size_t i = 0; i < m.size(); ++i) result[i][i] += p[k];
  }
  return result;
}

/// Coefficients of det(z - M), lowest power of z first, for any field of characteristic 0.
///
/// source  Faddeev & Sominsky (1949); Le Verrier (1840)
template <class F>
std::vector<F> characteristic_coefficients(const SquareMatrix<F>& m) {
  const std::size_t size = m.size();
  std::vector<F> p(size + 1, F(0));
  p[size] = F(1);
  SquareMatrix<F> a(size, std::vector<F>(size, F(0)));
  for (std::size_t k = 1; k <= size; ++k) {
    for (std::size_t i = 0; i < size; ++i) a[i][i] += p[size - k + 1];
    a = product(m, a);
    F trace(0);
    for (std::size_t i = 0; i < size; ++i) trace += a[i][i];
    p[size - k] = -trace / F(static_cast<int>(k));
  }
  return p;
}

}  // namespace shortfall
