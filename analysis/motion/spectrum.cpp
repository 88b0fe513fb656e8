// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/spectrum.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

Matrix shifted(Matrix m, const Fraction& value) {
  for (std::size_t i = 0; i < m.size(); ++i) m[i][i] -= value;
  return m;
}

bool is_zero(const Matrix& m) {
  return std::ranges::all_of(m, [](const auto& row) { return std::ranges::all_of(row, [](const Fraction& f) { return f.is_zero(); }); });
}

/// Whether every eigenvalue is 1: the common case, seen without a characteristic polynomial.
bool is_unipotent(const Matrix& m) {
  Matrix power = shifted(m, 1);
  const Matrix n = power;
  for (std::size_t k = 1; k < m.size() && !is_zero(power); ++k) power = power * n;
  return is_zero(power);
}

std::vector<std::pair<Fraction, int>> eigenvalues(const Matrix& m) {
  const std::vector<Fraction> p = characteristic_polynomial(m);
  Polynomial common = 1;
  for (const Fraction& c : p) common = common * exact_quotient(c.denominator(), gcd(common, c.denominator()));
  // The time letter does not occur in a step's matrix; here it stands for the unknown eigenvalue.
  Polynomial cleared;
  for (std::size_t k = 0; k < p.size(); ++k)
    cleared += (p[k] * Fraction(common)).numerator() * Polynomial::letter(kTimeLetter, static_cast<int>(k));
  std::vector<std::pair<Fraction, int>> values;
  for (const auto& [factor, multiplicity] : factor(cleared).factors) {
    const int degree = factor.degree(kTimeLetter);
    if (degree == 0) continue;
    if (degree > 1)
      throw Unable("an eigenvalue of the step is no rational function of its letters; such motions have no closed form of this kind");
    values.emplace_back(-Fraction(factor.coefficient(kTimeLetter, 0), factor.coefficient(kTimeLetter, 1)), multiplicity);
  }
  return values;
}

}  // namespace

Matrix identity_matrix(int size) {
  Matrix m(size, std::vector<Fraction>(size));
  for (int i = 0; i < size; ++i) m[i][i] = 1;
  return m;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  const std::size_t size = a.size();
  Matrix result(size, std::vector<Fraction>(size));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < size; ++k) {
      if (a[i][k].is_zero()) continue;
      for (std::size_t j = 0; j < size; ++j)
        if (!b[k][j].is_zero()) result[i][j] += a[i][k] * b[k][j];
    }
  return result;
}

std::vector<Fraction> characteristic_polynomial(const Matrix& m) {
  const int size = static_cast<int>(m.size());
  std::vector<Fraction> p(size + 1);
  p[size] = 1;
  Matrix a(size, std::vector<Fraction>(size));
  for (int k = 1; k <= size; ++k) {
    for (int i = 0; i < size; ++i) a[i][i] += p[size - k + 1];
    a = m * a;
    Fraction trace;
    for (int i = 0; i < size; ++i) trace += a[i][i];
    p[size - k] = -trace / Fraction(k);
  }
  return p;
}

std::vector<SpectralPart> spectral_parts(const Matrix& m) {
  const int size = static_cast<int>(m.size());
  if (is_unipotent(m)) return {{1, size, identity_matrix(size), shifted(m, 1)}};
  const auto values = eigenvalues(m);
  std::vector<SpectralPart> parts;
  for (const auto& [value, multiplicity] : values) {
    // 1/g as a power series in z - value, where g is the product of the other factors; then the projector is g(M) (1/g)(M).
    std::vector<Fraction> g(multiplicity);
    g[0] = 1;
    Matrix others = identity_matrix(size);
    for (const auto& [other, times] : values) {
      if (other == value) continue;
      for (int k = 0; k < times; ++k) {
        for (int j = multiplicity - 1; j >= 0; --j) g[j] = g[j] * (value - other) + (j > 0 ? g[j - 1] : Fraction());
        others = others * shifted(m, other);
      }
    }
    std::vector<Fraction> inverse(multiplicity);
    inverse[0] = Fraction(1) / g[0];
    for (int j = 1; j < multiplicity; ++j) {
      for (int i = 1; i <= j; ++i) inverse[j] -= g[i] * inverse[j - i];
      inverse[j] /= g[0];
    }
    Matrix series(size, std::vector<Fraction>(size));
    Matrix power = identity_matrix(size);
    const Matrix n = shifted(m, value);
    for (int j = 0; j < multiplicity; ++j, power = power * n)
      for (int r = 0; r < size; ++r)
        for (int c = 0; c < size; ++c) series[r][c] += inverse[j] * power[r][c];
    SpectralPart part{value, multiplicity, others * series, {}};
    part.nilpotent = n * part.projector;
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace shortfall
