// SPDX-License-Identifier: GPL-3.0-or-later
// Powers, binomials and factorials, which GMP multiplies out.
#include <algorithm>
#include <string>
#include <utility>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/rational.hpp"

namespace shortfall {

Rational Rational::pow(int exponent) const {
  if (exponent < 0 && is_zero()) throw Undefined("zero has no negative power");
  if (exponent == 0 || is_one()) return 1;
  if (exponent == 1 || is_zero()) return *this;
  mpz_class above = gmp_numerator(*this);
  mpz_class below = gmp_denominator(*this);
  const auto power = static_cast<unsigned long>(exponent < 0 ? -static_cast<long>(exponent) : exponent);
  const std::size_t bits =
      std::max(mpz_sizeinbase(above.get_mpz_t(), 2), mpz_sizeinbase(below.get_mpz_t(), 2));
  constexpr std::size_t kMostBits = std::size_t{1} << 30;
  if (bits > 1 && bits - 1 > kMostBits / power)
    throw Unable("the power " + std::to_string(exponent) + " of a number of " + std::to_string(bits) +
                 " bits would have more than 2^30 bits, which is our limit");
  mpz_pow_ui(above.get_mpz_t(), above.get_mpz_t(), power);
  mpz_pow_ui(below.get_mpz_t(), below.get_mpz_t(), power);
  if (exponent < 0) above.swap(below);
  // Powers of coprime numbers stay coprime; only the sign may stand in the wrong place.
  if (below < 0) {
    above = -above;
    below = -below;
  }
  mpq_class value;
  value.get_num().swap(above);
  value.get_den().swap(below);
  return rational(std::move(value));
}

Rational binomial(int n, int k) {
  if (k < 0 || k > n) return 0;
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
  return rational(result);
}

Rational factorial(int n) {
  if (n < 0) throw Undefined("the factorial of " + std::to_string(n) + " is not defined");
  mpz_class result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return rational(result);
}

}  // namespace shortfall
