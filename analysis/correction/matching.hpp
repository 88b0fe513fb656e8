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

  /// An expression with the values put in.
  Fraction put_into(Fraction f) const;
};

/// A point at which the solution that is wanted is known: the values of letters there, 0 for the unknowns.
using BranchPoint = std::vector<std::pair<Letter, Rational>>;

/// Solves for one or two unknown letters, the branch that passes through a point: by linear equations where
/// these eliminate one after the other; otherwise the equations are reduced to the factors that vanish at the
/// point.
///
/// One unknown: a common root exists in some extension of the field if and only if the greatest common
/// divisor of the conditions contains the unknown; so `impossible` is a proof for letters that are
/// independent.
Matching matching(const std::vector<Fraction>& conditions, const std::vector<Letter>& unknowns,
                  const BranchPoint& point, const std::vector<std::string>& names);

/// The determinant of the derivatives of the equations by the unknowns at the point. Where it is not 0 the
/// equations have one solution near the point, and that is analytic in the other letters (implicit function
/// theorem).
Fraction branch_jacobian(const Matching& m, const BranchPoint& point);

}  // namespace shortfall
