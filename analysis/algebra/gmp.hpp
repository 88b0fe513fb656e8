// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one door between Rational and GMP; only a file that calls a number library includes it.

#include <gmpxx.h>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/wide.hpp"

namespace shortfall {

mpz_class gmp_integer(Int128 value);
mpq_class gmp(const Rational& value);
mpz_class gmp_numerator(const Rational& value);
mpz_class gmp_denominator(const Rational& value);

/// The same number; the argument must be in lowest terms (as GMP's own arithmetic leaves it).
Rational rational(mpq_class value);
Rational rational(const mpz_class& value);
/// numerator / denominator, reduced here; the denominator may be negative but not zero.
Rational rational(mpz_class numerator, mpz_class denominator);
Rational rational(Int128 numerator, Int128 denominator);

}  // namespace shortfall
