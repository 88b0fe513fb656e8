// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

/// The polynomials S_m(n) = 0^m + 1^m + ... + (n-1)^m (with 0^0 = 1) for m = 0..highest, as coefficients of
/// n^0, n^1, ...
///
/// Each is the integral of m times the one before, plus the multiple of n that makes S_m(1) right; that
/// multiple is Bernoulli's number B_m. source  Bernoulli (1713), Ars Conjectandi II, 3;  Knuth (1993), Johann
/// Faulhaber and sums of powers
std::vector<std::vector<Rational>> power_sums(int highest);

/// The sum of p(k) for k = 0 .. n-1 as a polynomial in the letter n, for p a polynomial in n with
/// coefficients in the other letters.
///
/// throws  Undefined  when n stands in a denominator
Fraction indefinite_sum(const Fraction& p, Letter n);

}  // namespace shortfall
