// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// Small whole numbers c_0, .., c_d, not all 0, with c_0 + c_1 x + ... + c_d x^d near 0, for an x known to so
/// many digits after its point: the shortest vector that lattice reduction finds.
///
/// It is a guess. Whether it is small enough to be no accident is for the caller to say.
///
/// source  Lenstra, Lenstra & Lovasz (1982), Factoring polynomials with rational coefficients; Kannan,
/// Lenstra & Lovasz (1988), Polynomial factorization and nonrandomness of bits of algebraic and some
/// transcendental numbers
std::vector<Rational> small_polynomial(const Rational& x, int degree, int digits);

}  // namespace shortfall
