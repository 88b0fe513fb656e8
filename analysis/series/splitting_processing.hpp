// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/algebra/homological_equation.hpp"
#include "analysis/algebra/lie_element.hpp"
#include "analysis/algebra/lie_quotient.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

/// Why no launch and read-out takes a method further: linear functionals that every bracket with A + B has 0,
/// and that this method has not.
template <class Field>
struct SplittingObstruction {
  int degree = 0;
  /// Whole numbers, in the coordinates of the quotient's basis of that degree.
  std::vector<std::vector<Rational>> functionals;
  std::vector<Field> values;  ///< their values, not all zero
};

/// What processing makes of a step exp(L): launch with P, then steps, then read out with the inverse of P, so
/// that P exp(L) P^-1 is exp(A + B) to a higher power of h than exp(L) itself.
///
/// All elements are classes of the quotient in its normal form, h being 1.
template <class Field>
struct SplittingProcessing {
  VectorFields kind = VectorFields::any;
  LieElement<Field> logarithm;  ///< L
  /// The order of the step alone: L = A + B up to this degree; 0 when it is not consistent.
  int order = 0;
  /// The order of the processed method; `degree` of L where that does not tell more (see obstruction).
  int effective_order = 0;
  /// c_1, c_2, ..., each of its degree alone: P = exp(c_(p-1)) ... exp(c_2) exp(c_1), leftmost applied first.
  /// c_1 is without A: it moves velocities only.
  std::vector<LieElement<Field>> corrections;
  LieElement<Field> processed;                             ///< the logarithm of P exp(L) P^-1
  std::optional<SplittingObstruction<Field>> obstruction;  ///< none when the last degree was reached
};

/// Looks for P degree by degree: c_(n-1) from [c_(n-1), A + B] = -L_n, then L = exp(ad c_(n-1)) L.
///
/// That a functional does not vanish does not depend on choices made before: P is unique up to a shift of
/// time.
///
/// source  Butcher (1969), The effective order of Runge-Kutta methods; Blanes, Casas & Murua (2004), On the
/// numerical integration of ordinary differential equations by processed methods, SIAM Journal on Numerical
/// Analysis 42
template <class Field>
SplittingProcessing<Field> splitting_processing(const LieElement<Field>& logarithm, VectorFields kind);

/// The logarithm of P.
template <class Field>
LieElement<Field> corrector_logarithm(const SplittingProcessing<Field>& result);

/// The highest degree up to which the logarithm is A + B in the quotient; 0 when not even in degree 1.
template <class Field>
int splitting_order(const LieElement<Field>& logarithm, VectorFields kind);

}  // namespace shortfall
