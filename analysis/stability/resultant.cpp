// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/resultant.hpp"

#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

/// The determinant without fractions: every division is exact.
///
/// source  Bareiss (1968), Sylvester's identity and multistep integer-preserving Gaussian elimination
Polynomial determinant(std::vector<std::vector<Polynomial>> m) {
  const std::size_t size = m.size();
  Polynomial last = 1;
  bool negative = false;
  for (std::size_t p = 0; p + 1 < size; ++p) {
    std::size_t row = p;
    while (row < size && m[row][p].is_zero()) ++row;
    if (row == size) return {};
    if (row != p) {
      std::swap(m[row], m[p]);
      negative = !negative;
    }
    for (std::size_t i = p + 1; i < size; ++i)
      for (std::size_t j = p + 1; j < size; ++j)
        m[i][j] = exact_quotient(m[p][p] * m[i][j] - m[i][p] * m[p][j], last);
    last = m[p][p];
  }
  return negative ? -m[size - 1][size - 1] : m[size - 1][size - 1];
}

}  // namespace

Polynomial resultant(const Polynomial& a, const Polynomial& b, Letter letter) {
  if (a.is_zero() || b.is_zero()) throw Undefined("the resultant of the zero polynomial");
  const std::vector<Polynomial> p = a.coefficients(letter), q = b.coefficients(letter);
  const std::size_t m = p.size() - 1, n = q.size() - 1;
  if (m == 0) return p[0].pow(static_cast<int>(n));
  if (n == 0) return q[0].pow(static_cast<int>(m));
  std::vector<std::vector<Polynomial>> sylvester(m + n, std::vector<Polynomial>(m + n));
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t k = 0; k <= m; ++k) sylvester[row][row + k] = p[m - k];
  for (std::size_t row = 0; row < m; ++row)
    for (std::size_t k = 0; k <= n; ++k) sylvester[n + row][row + k] = q[n - k];
  return determinant(std::move(sylvester));
}

Polynomial multiple_root_condition(const Polynomial& p, Letter letter) {
  const Polynomial slope = p.derivative(letter);
  return slope.is_zero() ? Polynomial(1) : resultant(p, slope, letter);
}

}  // namespace shortfall
