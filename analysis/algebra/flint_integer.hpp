// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/flint.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

/// An integer of FLINT for as long as it lives; for files that call FLINT or Arb.
struct FlintInteger {
  FlintInteger() { fmpz_init(value); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;
  ~FlintInteger() { fmpz_clear(value); }
  mpz_class gmp() const {
    mpz_class z;
    fmpz_get_mpz(z.get_mpz_t(), value);
    return z;
  }
  Rational rational() const {
    return fmpz_fits_si(value) ? Rational(fmpz_get_si(value)) : shortfall::rational(gmp());
  }
  fmpz_t value;
};

}  // namespace shortfall
