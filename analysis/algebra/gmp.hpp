// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one door between Rational and GMP; only a file that calls a number library includes it.

#include <gmpxx.h>

#include <array>

#include "analysis/algebra/rational.hpp"
#include "analysis/algebra/wide.hpp"

namespace shortfall {

/// A rational as GMP reads it, without a copy: its own GMP integers, or its two words lent out. It must
/// outlive the view, unchanged.
class GmpView {
 public:
  explicit GmpView(const Rational& r);
  GmpView(const GmpView&) = delete;
  GmpView& operator=(const GmpView&) = delete;
  mpq_srcptr get() const { return read_; }
  mpz_srcptr numerator() const { return mpq_numref(read_); }
  mpz_srcptr denominator() const { return mpq_denref(read_); }

 private:
  std::array<mp_limb_t, 2> words_;
  mpq_t lent_;
  mpq_srcptr read_;
};

/// How many binary digits |value| has; 0 for 0.
inline long bit_length(const mpz_class& value) {
  return value == 0 ? 0 : static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

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
