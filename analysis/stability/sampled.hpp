// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "analysis/stability/amplification.hpp"
#include "analysis/stability/stability_function.hpp"

namespace shortfall {

/// Amplification in binary64, for pictures only: nothing is concluded from it.
class SampledEigenvalues {
 public:
  /// param   a  its parameters numbers, no damping
  explicit SampledEigenvalues(const Amplification& a);

  /// Sizes of the eigenvalues that are not always 0, largest first, at h w = z.
  std::vector<double> sizes(double z) const;

 private:
  std::vector<std::vector<double>> numerators_;  ///< of the characteristic polynomial's coefficients, in y
  std::vector<std::vector<double>> denominators_;
};

/// A stability function in binary64.
class SampledFunction {
 public:
  explicit SampledFunction(const StabilityFunction& r);

  double size(std::complex<double> z) const;  ///< |R(z)|

 private:
  std::vector<double> numerator_;
  std::vector<double> denominator_;
};

/// All roots of a polynomial, lowest coefficient first.
///
/// source  Durand (1960); Kerner (1966), Ein Gesamtschrittverfahren zur Berechnung der Nullstellen von
/// Polynomen
std::vector<std::complex<double>> sampled_roots(const std::vector<double>& polynomial);

}  // namespace shortfall
