// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/sampled.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

#include "analysis/problems/letters.hpp"

namespace shortfall {

namespace {

std::vector<double> rounded(const Univariate<Rational>& p) {
  std::vector<double> result;
  for (const Rational& c : p.coefficients()) result.push_back(c.to_double());
  return result;
}

template <class T>
T value(const std::vector<double>& p, T x) {
  T sum = 0;
  for (std::size_t k = p.size(); k-- > 0;) sum = sum * x + p[k];
  return sum;
}

}  // namespace

SampledEigenvalues::SampledEigenvalues(const Amplification& a) {
  for (Fraction c : a.nonzero) {
    for (const AlgebraicLetter& letter : a.algebraic)
      c = c.substitute(letter.letter,
                       Fraction(letter.value.refined(Rational(1) / Rational(2).pow(100)).low()));
    numerators_.push_back(rounded(univariate(c.numerator(), kStiffness)));
    denominators_.push_back(rounded(univariate(c.denominator(), kStiffness)));
  }
}

std::vector<double> SampledEigenvalues::sizes(double z) const {
  std::vector<double> polynomial;
  for (std::size_t k = 0; k < numerators_.size(); ++k)
    polynomial.push_back(value(numerators_[k], z * z) / value(denominators_[k], z * z));
  std::vector<double> result;
  for (const std::complex<double>& root : sampled_roots(polynomial)) result.push_back(std::abs(root));
  std::ranges::sort(result, std::greater<>());
  return result;
}

SampledFunction::SampledFunction(const StabilityFunction& r) {
  for (const Algebraic& c : r.numerator.coefficients()) numerator_.push_back(c.to_double());
  for (const Algebraic& c : r.denominator.coefficients()) denominator_.push_back(c.to_double());
}

double SampledFunction::size(std::complex<double> z) const {
  return std::abs(value(numerator_, z) / value(denominator_, z));
}

std::vector<std::complex<double>> sampled_roots(const std::vector<double>& p) {
  using Complex = std::complex<double>;
  const std::size_t degree = p.size() - 1;
  if (degree == 2) {  // exactly where it matters most: both on the circle
    const Complex half = -p[1] / p[2] / 2, radical = std::sqrt(Complex(half * half - p[0] / p[2]));
    return {half + radical, half - radical};
  }
  double reach = 0;
  for (std::size_t k = 0; k < degree; ++k) reach = std::max(reach, std::abs(p[k] / p[degree]));
  std::vector<Complex> roots;
  for (std::size_t k = 0; k < degree; ++k)
    roots.push_back(std::polar(
        1 + reach / 2, 0.4 + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(degree)));
  for (int round = 0; round < 500; ++round) {
    double moved = 0;
    for (Complex& root : roots) {
      Complex product = p[degree];
      for (const Complex& other : roots)
        if (&other != &root) product *= root - other;
      const Complex step = value(p, root) / product;
      root -= step;
      moved = std::max(moved, std::abs(step));
    }
    if (moved < 1e-14 * (1 + reach)) break;
  }
  return roots;
}

}  // namespace shortfall
