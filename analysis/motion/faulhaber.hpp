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

/// Bernoulli's numbers B_0 = 1, B_1 = -1/2, B_2 = 1/6, 0, B_4 = -1/30, ... up to B_highest.
///
/// From the tangent numbers, which are whole: no greatest common divisor but one for each number.
/// source  Brent & Harvey (2013), Fast computation of Bernoulli, Tangent and Secant numbers, section 5
std::vector<Rational> bernoulli_numbers(int highest);

/// The sum of p(k) for k = 0 .. n-1 as a polynomial in the letter n, for p a polynomial in n with
/// coefficients in the other letters.
///
/// throws  Undefined  when n stands in a denominator
Fraction indefinite_sum(const Fraction& p, Letter n);

}  // namespace shortfall
