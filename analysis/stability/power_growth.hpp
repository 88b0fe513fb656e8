// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/stability/algebraic_over.hpp"

namespace shortfall {

/// Eigenvalues of a matrix that lie on the unit circle, of one kind and one multiplicity.
struct CircleEigenvalues {
  enum class Kind { plus_one, minus_one, pairs };
  Kind kind = Kind::pairs;
  int count = 0;                   ///< how many different ones; 2 for a conjugate pair
  int multiplicity = 0;            ///< of each of them
  int largest_block = 0;           ///< size of their largest Jordan block; 1 when they are semisimple
  std::optional<Rational> cosine;  ///< of the angle of a single pair, when it is rational
};

/// How the powers of a matrix grow, decided exactly from its Jordan form.
struct PowerGrowth {
  enum class Kind { bounded, polynomial, exponential };
  Kind kind = Kind::bounded;
  int degree = 0;                         ///< polynomial: like n^degree
  bool decays = false;                    ///< every eigenvalue lies inside the circle
  int inside = 0;                         ///< how many do, 0 not counted; meaningful unless exponential
  std::vector<CircleEigenvalues> circle;  ///< empty when the growth is exponential

  bool bounded() const { return kind == Kind::bounded; }
};

/// Decides it over an exact ordered field F (Rational, Algebraic, AlgebraicOver), without knowing an
/// eigenvalue.
///
/// The characteristic polynomial is split into square-free parts, each of them into what it shares with its
/// reversal and the rest. The rest has no root on the circle and must pass the test of Schur and Cohn; the
/// shared part, as a polynomial in u = z + 1/z, must have all its roots between -2 and 2, which Sturm's
/// sequence counts. Repeated eigenvalues on the circle are held against the matrix itself.
///
/// shape   square
/// source  Jury (1964), Theory and Application of the z-Transform Method; Hairer, Lubich & Wanner (2006), I.5
template <class F>
PowerGrowth power_growth(const std::vector<std::vector<F>>& matrix);

extern template PowerGrowth power_growth(const std::vector<std::vector<Rational>>&);
extern template PowerGrowth power_growth(const std::vector<std::vector<Algebraic>>&);
extern template PowerGrowth power_growth(const std::vector<std::vector<AlgebraicOver>>&);

}  // namespace shortfall
