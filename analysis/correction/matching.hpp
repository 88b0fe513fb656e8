// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

/// What came of solving conditions = 0 for one or two unknowns.
struct Matching {
  enum class Kind {
    rational,    ///< values: rational functions of the other letters
    algebraic,   ///< equations: polynomials that vanish there, and no rational function does
    impossible,  ///< no value at all, in whatever field: proved
    unknown,     ///< we found none
  };
  Kind kind = Kind::unknown;
  std::vector<Letter> unknowns;
  std::vector<Fraction> values;       ///< one for each unknown
  std::vector<Polynomial> equations;  ///< as many as unknowns
  std::string obstruction;            ///< why
  bool only = false;                  ///< a rational solution besides which there is none

  /// An expression with the values put in.
  Fraction put_into(Fraction f) const;
};

/// A point at which the solution that is wanted is known: values of letters there. The step h is 0 there, and
/// so are the unknowns h^2 k and h c.
using BranchPoint = std::vector<std::pair<Letter, Rational>>;

/// What is left of a polynomial for h -> 0 with h^2 k and h c fixed, divided by the power of h that it
/// vanishes with: its terms of lowest order, where k and c now stand for h^2 k and h c.
Polynomial small_step_part(const Polynomial& p);

/// Solves for one or two unknown letters, the branch that passes through a point: by linear equations where
/// these eliminate one after the other; otherwise the equations are reduced to the factors that vanish at the
/// point.
///
/// One unknown: a common root exists in some extension of the field if and only if the greatest common
/// divisor of the conditions contains the unknown; so `impossible` is a proof for letters that are
/// independent.
Matching matching(const std::vector<Fraction>& conditions, const std::vector<Letter>& unknowns,
                  const BranchPoint& point, const std::vector<std::string>& names);

/// The determinant of the derivatives of the equations by h^2 k and h c at the point. Where it is not 0 the
/// equations have one solution near the point, and that is analytic in the other letters (implicit function
/// theorem).
Fraction branch_jacobian(const Matching& m, const BranchPoint& point);

}  // namespace shortfall
