// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "analysis/stability/amplification.hpp"
#include "analysis/stability/windows.hpp"

namespace shortfall {

/// R(z) = P(z)/Q(z): what one step multiplies the solution of y' = lambda y by, z = h lambda a complex
/// number.
///
/// Invariant: P and Q have no common factor, and Q(0) = 1. Their coefficients are real algebraic numbers of
/// one field.
struct StabilityFunction {
  Univariate<Algebraic> numerator;
  Univariate<Algebraic> denominator;
  Algebraic::Generator generator;  ///< of the coefficients' field; none when they are rational
  Fraction formula;                ///< the same with z in the letter of k, and letters for algebraic numbers
  std::vector<std::string> letters;        ///< names of the letters, see letters.hpp
  std::vector<AlgebraicLetter> algebraic;  ///< none: the coefficients are rational

  Algebraic at(const Rational& z) const;  ///< throws Undefined at a pole
  /// |R| at infinity; none when it is infinite.
  std::optional<Algebraic> size_at_infinity() const;
};

/// P/Q in lowest terms.
///
/// throws  Undefined  when there is a pole at 0
StabilityFunction stability_function(const Univariate<Rational>& p, const Univariate<Rational>& q);

/// det(1 - z A + z 1 b^T) / det(1 - z A).
///
/// source  Hairer & Wanner (1996), Solving Ordinary Differential Equations II, IV.3, Proposition 3.2
StabilityFunction stability_function(const Tableau& tableau, const Values& parameters);

/// Of an integrator: from its tableau, or from its step when that treats every linear problem z' = A z as z
/// <- R(h A) z, which is proved for x'' = -k x - c v in letters. None for the others: they treat positions
/// and velocities differently.
std::optional<StabilityFunction> stability_function(const Program& program, const Values& given = {});

/// The same from the matrix of one step with damping, its parameters numbers.
std::optional<StabilityFunction> stability_function(const Amplification& damped);

/// What is proved about a stability function.
struct StabilityProperties {
  bool poles_right = false;  ///< every pole has a positive real part (Routh and Hurwitz)
  /// |Q(iy)|^2 - |P(iy)|^2, a polynomial in y^2: not negative anywhere on the imaginary axis, which Sturm's
  /// sequence decides.
  Univariate<Algebraic> difference;
  bool imaginary_axis = false;
  std::optional<Rational> violated_at;  ///< a y > 0 with |R(iy)| > 1, when there is one
  bool a_stable = false;  ///< |R(z)| <= 1 wherever Re z <= 0: both of the above, by the maximum principle
  bool l_stable = false;  ///< and R(z) -> 0 for z -> infinity
  Windows real_axis;      ///< where |R(-s)| <= 1, s > 0
};

StabilityProperties stability_properties(const StabilityFunction& r);

/// Whether every root of p has a negative real part.
///
/// source  Routh (1877), A Treatise on the Stability of a Given State of Motion; Hurwitz (1895)
bool is_hurwitz(const Univariate<Algebraic>& p);

}  // namespace shortfall
