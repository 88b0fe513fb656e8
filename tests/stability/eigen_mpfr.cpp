// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenvalues at the limits to 100 digits, by Eigen over MPFR: exact limits are held against 30 of them. One
// EigenSolver in this file: it takes its time to compile.
#include <doctest/doctest.h>

#ifdef SHORTFALL_WITH_EIGEN
#include <Eigen/Eigenvalues>
#include <boost/multiprecision/eigen.hpp>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;

namespace {

constexpr int kDigits = 100;

/// The largest size of an eigenvalue.
Real spectral_radius(const SquareMatrix<Rational>& m) {
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index n = static_cast<Eigen::Index>(m.size());
  Matrix numbers(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      numbers(i, j) = real(m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)], kDigits);
  const Eigen::EigenSolver<Matrix> solver(numbers, false);
  Real largest = real(Rational(0), kDigits);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Real re = solver.eigenvalues()[i].real(), im = solver.eigenvalues()[i].imag();
    const Real square = re * re, other = im * im;
    const Real size = sqrt(Real(square + other));
    if (size > largest) largest = size;
  }
  return largest;
}

}  // namespace

TEST_CASE(
    "at 100 digits eigenvalues leave the circle exactly at the limit: 30 digits of every limit of the "
    "catalogue") {
  const Precision precision(kDigits);
  const Real one = real(Rational(1), kDigits), tiny = real(Rational(1) / Rational(10).pow(40), kDigits);
  int checked = 0;
  for (const Program& p : testing::undamped_catalogue()) {
    const auto limit = stability_limit(p);
    if (!limit || limit->compare(0) == 0) continue;
    CAPTURE(p.name);
    Amplification a = amplification(p, parameter_values(p));
    for (auto& row : a.matrix)  // irrational numbers to 100 digits
      for (Fraction& f : row)
        for (const AlgebraicLetter& letter : a.algebraic)
          f = f.substitute(letter.letter, Rational::parse(letter.value.decimal(kDigits)));
    const Rational at = Rational::parse(limit->decimal(60)), step = Rational(1) / Rational(10).pow(30);
    const Real before = spectral_radius(matrix_at(a.matrix, kStiffness, (at - step) * (at - step)));
    const Real after = spectral_radius(matrix_at(a.matrix, kStiffness, (at + step) * (at + step)));
    CHECK(before < Real(one + tiny));
    CHECK(after > Real(one + tiny));
    ++checked;
  }
  CHECK(checked > 10);
}
#else
TEST_CASE("eigenvalues by Eigen over MPFR" * doctest::skip()) {}
#endif
