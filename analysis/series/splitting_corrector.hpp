// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/series/splitting_parts.hpp"

namespace shortfall {

/// A symplectic corrector for drift-kick-drift with a small kick, A + eps B: kicks and drifts done once
/// before the first step, and undone at read-out, after which the error is eps O(h^(2 stages + 2)) + eps^2
/// O(h^2).
///
/// Stage i drifts by a_i = i alpha and kicks by b_i = weights[i - 1] / alpha, in units of h.
struct SymplecticCorrector {
  Rational alpha_squared;         ///< 7/40 in the published ones
  std::vector<Rational> weights;  ///< r_1, r_2, ...

  Surd a(int i) const { return Surd(Rational(i)) * Surd::sqrt(alpha_squared); }
  Surd b(int i) const { return Surd(weights[static_cast<std::size_t>(i) - 1]) / Surd::sqrt(alpha_squared); }
  /// The corrector itself, to be done before the first step: Z(-a_m, b_m) ... Z(-a_1, b_1) Z(a_1, -b_1) ...
  /// Z(a_m, -b_m) in the order of application, with Z(a, b) = drift a, kick b, drift -2 a, kick -b, drift a.
  SplittingParts<Surd> parts() const;
};

/// The weights of a corrector with so many stages, from exact linear equations.
///
/// The logarithm of drift-kick-drift is A + eps l(x) B, x = ad A, to first order in eps; a corrector with
/// logarithm eps c(x) B adds -x c(x), so that c = (l - 1) / x is wanted. The stages give
/// -4 times the sum of b_i sinh(a_i x); equal odd powers of x are as many equations as there are stages.
///
/// throws  BadInput  when stages is not from 1 to 30;  Undefined  when alpha_squared is not positive
/// source  Wisdom (2006), Symplectic correctors for canonical heliocentric n-body maps, Astronomical Journal
/// 131, 2294
SymplecticCorrector symplectic_corrector(int stages, const Rational& alpha_squared = Rational(7, 40));

/// The stages of the corrector that is known by a number: the published ones, 3, 5, 7, 11 and 17, have 1, 2,
/// 3, 5 and 8.
///
/// throws  BadInput  for a number that is not odd, or not from 3 to 61
int corrector_stages(int number);

}  // namespace shortfall
