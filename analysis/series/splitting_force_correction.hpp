// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/algebra/lie_element.hpp"
#include "analysis/series/splitting_parts.hpp"
#include "analysis/series/splitting_processing.hpp"

namespace shortfall {

/// A force that reads positions only, put in place of a in every kick, so that the processed method is of a
/// higher effective order for x'' = a(x).
///
/// The brackets that are kicks again have one drift less than they have kicks: [[A,B],B] is -2 a_x[a], so
/// that B - 1/24 h^2 [[A,B],B] stands for a + h^2/12 a_x[a].
template <class Field>
struct SplittingForceCorrection {
  LieElement<Field> kick;  ///< B + ..., in place of B
  SplittingProcessing<Field> processing;
  /// Where it stopped: that degree's conditions, and how many kicks were free to meet them.
  struct Limit {
    int degree = 0;
    int conditions = 0;
    int unknowns = 0;
    /// Multipliers of the obstruction's values that no kick of this degree changes, and the sum that they
    /// give: not 0, so that no kick helps.
    std::vector<Rational> certificate;
    Field residual;
    /// Lower degrees left no choice of kicks, so that "impossible" holds for every position-only correction.
    bool conclusive = true;
  };
  std::optional<Limit> limit;
};

/// The kicks of one degree in the mechanical quotient, as places in its basis.
std::vector<int> position_only_kicks(int degree);

/// The logarithm of a step whose kicks are weight times another kick than B.
template <class Field>
LieElement<Field> splitting_logarithm(const SplittingParts<Field>& parts, const LieElement<Field>& kick);

/// Corrects the force degree by degree, no more than is needed, up to a degree.
///
/// source  Takahashi & Imada (1984), Monte Carlo calculation of quantum systems II; Rowlands (1991), A
/// numerical algorithm for Hamiltonian systems
template <class Field>
SplittingForceCorrection<Field> splitting_force_correction(const SplittingParts<Field>& parts, int degree);

}  // namespace shortfall
