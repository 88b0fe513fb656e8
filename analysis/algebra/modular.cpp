// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/modular.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {
namespace {

std::uint64_t remainder(const mpz_class& z) {
  const mpz_class prime = gmp_integer(Modular::kPrime);
  mpz_class rest;
  mpz_fdiv_r(rest.get_mpz_t(), z.get_mpz_t(), prime.get_mpz_t());
  std::uint64_t word = 0;
  mpz_export(&word, nullptr, -1, sizeof word, 0, 0, rest.get_mpz_t());
  return word;
}

}  // namespace

Modular::Modular(const Rational& value) {
  std::int64_t above, below;
  const bool small = value.fits_int64(above, below);
  *this = small ? Modular(above) : raw(remainder(gmp_numerator(value)));
  const Modular denominator = small ? Modular(below) : raw(remainder(gmp_denominator(value)));
  if (denominator.is_zero())
    throw Undefined("a rational whose denominator 2^61 - 1 divides has no fingerprint");
  if (denominator != 1) *this /= denominator;
}

Modular Modular::inverse() const {
  if (is_zero()) throw Undefined("division by zero modulo 2^61 - 1");
  // Fermat: a^(p-1) = 1.
  return pow(static_cast<std::int64_t>(kPrime) - 2);
}

Modular Modular::pow(std::int64_t exponent) const {
  if (exponent < 0) return inverse().pow(-(exponent + 1)) * inverse();
  Modular result = 1, square = *this;
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) result *= square;
    square *= square;
  }
  return result;
}

}  // namespace shortfall
