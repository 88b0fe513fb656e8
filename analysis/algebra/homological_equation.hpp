// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/lie_quotient.hpp"
#include "analysis/algebra/rational_system.hpp"

namespace shortfall {

/// [c, A + B] = r for c of degree n - 1 in a quotient of the free Lie algebra, made once for each degree.
///
/// Unknowns and right-hand side are coordinates in the quotient's bases of the degrees n - 1 and n. Only
/// degree 1 has a kernel, A + B itself, and there the solution without A is given: a kick.
///
/// throws  Unable  when n is not from 2 to 12
const RationalSystem& homological_equation(VectorFields kind, int n);

}  // namespace shortfall
