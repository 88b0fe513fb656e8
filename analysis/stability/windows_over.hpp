// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/stability/windows.hpp"

namespace shortfall {

/// `bounded_windows` over a field K of real algebraic numbers: for entries of the matrix that contain letters
/// for them.
///
/// The same argument as over the rationals, without factoring: the characteristic polynomial is split into
/// square-free parts over K(y), each of them into what it shares with its reversal and the rest. Critical
/// values are roots of polynomials over K, isolated as roots of their norms; at each of them the decision is
/// made in the field that it generates over K.
///
/// param   letters  not empty; each of them occurs in the matrix
Windows bounded_windows_over(const SquareMatrix<Fraction>& matrix, Letter letter,
                             const std::vector<AlgebraicLetter>& letters);

}  // namespace shortfall
