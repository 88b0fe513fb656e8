// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/real_roots.hpp"
#include "analysis/stability/power_growth.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall {

/// `power_growth` of a matrix of one or two rows, whose entries are rational functions of a letter, at an
/// irrational real root: by the signs of 1 - D, 1 - T + D and 1 + T + D there.
///
/// Nothing is computed in the number field of the root. A sign is seen in a ball of the root; a value that
/// stays too near to 0 for that is 0 if and only if the root's irreducible polynomial divides its numerator.
///
/// param   root    irrational; no denominator of the matrix vanishes there
/// throws  Error   for a matrix of another size
/// source  Jury (1964), Theory and Application of the z-Transform Method, for degree two
PowerGrowth growth_at_root(const SquareMatrix<Fraction>& matrix, Letter letter, const RealRoot& root);

/// The sign of a rational function at an irrational root: -1, 0 or 1, exact.
int sign_at_root(const Fraction& f, Letter letter, const RealRoot& root);

}  // namespace shortfall
