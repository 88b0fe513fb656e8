// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/problems/letters.hpp"

namespace shortfall {

/// The letter in which the characteristic polynomial of a step is written; a step's matrix does not contain
/// it.
inline constexpr Letter kEigenvalue = kTimeLetter;

/// The eigenvalues of a step: zeros, the two that approximate the motion, and the rest.
///
/// All polynomials are monic, lowest power first, with rational functions as coefficients.
struct MotionPair {
  int zeros = 0;                  ///< multiplicity of the eigenvalue 0
  std::vector<Fraction> nonzero;  ///< the characteristic polynomial over z^zeros
  std::vector<Fraction> pair;     ///< {D, -T, 1}; empty when it is no factor over the rational functions
  std::vector<Fraction> spurious{Fraction(1)};  ///< nonzero / pair; meaningful when there is a pair
};

/// By factorisation, where there are more than two.
///
/// param   characteristic     coefficients, lowest power first
/// param   belongs_to_motion  whether an irreducible factor, in kEigenvalue, tends to a power of z - 1
MotionPair motion_pair(const std::vector<Fraction>& characteristic,
                       const std::function<bool(const Polynomial&)>& belongs_to_motion);

}  // namespace shortfall
