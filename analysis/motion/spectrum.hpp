// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

using Matrix = std::vector<std::vector<Fraction>>;

Matrix identity_matrix(int size);
Matrix operator*(const Matrix& a, const Matrix& b);

/// Coefficients of det(z - M), lowest power of z first.
///
/// source  Faddeev & Sominsky (1949); Le Verrier (1840)
std::vector<Fraction> characteristic_polynomial(const Matrix& m);

/// One eigenvalue of a matrix, with the projector on its generalised eigenspace along the others and N = (M -
/// value) projector.
struct SpectralPart {
  Fraction value;
  int multiplicity;
  Matrix projector;
  Matrix nilpotent;
};

/// The spectral decomposition of a matrix of rational functions, as far as its eigenvalues are rational
/// functions too.
///
/// The others are kept together: `rest` is the monic product of their factors of the characteristic
/// polynomial (lowest power first; {1} when there is none) and `rest_projector` projects on their part of the
/// space.
struct Spectrum {
  std::vector<SpectralPart> parts;
  std::vector<Fraction> rest{Fraction(1)};
  Matrix rest_projector;

  int rest_size() const { return static_cast<int>(rest.size()) - 1; }
};

Spectrum spectrum(const Matrix& m);

}  // namespace shortfall
