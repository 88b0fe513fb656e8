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
  return std::ranges::all_of(m, [](const auto& row) {
    return std::ranges::all_of(row, [](const Fraction& f) { return f.is_zero(); });
  });
}

/// Whether every eigenvalue is 1: the common case, seen without a characteristic polynomial.
bool is_unipotent(const Matrix& m) {
  Matrix power = shifted(m, 1);
  const Matrix n = power;
  for (std::size_t k = 1; k < m.size() && !is_zero(power); ++k) power = power * n;
  return is_zero(power);
}

std::vector<Fraction> product(const std::vector<Fraction>& a, const std::vector<Fraction>& b) {
  std::vector<Fraction> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

/// p(M), lowest power first.
Matrix evaluated_at(const std::vector<Fraction>& p, const Matrix& m) {
  const int size = static_cast<int>(m.size());
  Matrix result(size, std::vector<Fraction>(size));
  for (std::size_t k = p.size(); k-- > 0;) {
    result = result * m;
    for (int i = 0; i < size; ++i) result[i][i] += p[k];
  }
  return result;
}

/// p(z + s) up to s^(count-1), for p lowest power first.
std::vector<Fraction> taylor(std::vector<Fraction> p, const Fraction& at, int count) {
  std::vector<Fraction> result;
  for (int k = 0; k < count; ++k) {
    // Divide by z - at (Horner): the remainder is the next coefficient.
    Fraction carry;
    for (std::size_t i = p.size(); i-- > 0;) {
      const Fraction next = p[i] + carry * at;
      p[i] = carry;
      carry = next;
    }
    result.push_back(carry);
    if (!p.empty()) p.pop_back();
  }
  return result;
}

/// The rational eigenvalues with their multiplicities; the product of the other factors goes to `rest`.
std::vector<std::pair<Fraction, int>> eigenvalues(const Matrix& m, std::vector<Fraction>& rest) {
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
    if (degree > 1) {
      const Fraction leading = factor.coefficient(kTimeLetter, degree);
      std::vector<Fraction> monic;
      for (const Polynomial& c : factor.coefficients(kTimeLetter)) monic.push_back(Fraction(c) / leading);
      for (int k = 0; k < multiplicity; ++k) rest = product(rest, monic);
      continue;
    }
    values.emplace_back(-Fraction(factor.coefficient(kTimeLetter, 0), factor.coefficient(kTimeLetter, 1)),
                        multiplicity);
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

Spectrum spectrum(const Matrix& m) {
  const int size = static_cast<int>(m.size());
  Spectrum result;
  if (is_unipotent(m)) {
    result.parts.push_back({1, size, identity_matrix(size), shifted(m, 1)});
    return result;
  }
  const auto values = eigenvalues(m, result.rest);
  result.rest_projector = identity_matrix(size);
  for (const auto& [value, multiplicity] : values) {
    // With g the product of the other factors and 1/g its inverse as a power series in z - value, the
    // projector is g(M) (1/g)(M).
    std::vector<Fraction> others = result.rest;
    for (const auto& [other, times] : values)
      for (int k = 0; k < times && !(other == value); ++k) others = product(others, {-other, 1});
    const std::vector<Fraction> g = taylor(others, value, multiplicity);
    std::vector<Fraction> inverse(multiplicity);
    inverse[0] = Fraction(1) / g[0];
    for (int j = 1; j < multiplicity; ++j) {
      for (int i = 1; i <= j; ++i) inverse[j] -= g[i] * inverse[j - i];
      inverse[j] /= g[0];
    }
    const Matrix n = shifted(m, value);
    SpectralPart part{value, multiplicity, evaluated_at(others, m) * evaluated_at(inverse, n), {}};
    part.nilpotent = n * part.projector;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < size; ++c) result.rest_projector[r][c] -= part.projector[r][c];
    result.parts.push_back(std::move(part));
  }
  return result;
}

}  // namespace shortfall
