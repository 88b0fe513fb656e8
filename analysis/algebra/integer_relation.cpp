// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/integer_relation.hpp"

#include "analysis/algebra/flint.hpp"

#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>

namespace shortfall {

std::vector<Rational> small_polynomial(const Rational& x, int degree, int digits) {
  const int columns = degree + 2;
  fmpz_mat_t lattice;
  fmpz_mat_init(lattice, degree + 1, columns);
  Rational power(1);
  const Rational scale = Rational(10).pow(digits);
  for (int k = 0; k <= degree; ++k) {
    fmpz_one(fmpz_mat_entry(lattice, k, k));
    // A whole number as text: the numbers are few, and no reader needs to know two of GMP's types.
    const Rational scaled = (power * scale + Rational(1, 2)).floor();
    fmpz_set_str(fmpz_mat_entry(lattice, k, degree + 1), scaled.str().c_str(), 10);
    power *= x;
  }
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(lattice, nullptr, context);
  std::vector<Rational> result;
  for (int k = 0; k <= degree; ++k) {
    char* text = fmpz_get_str(nullptr, 10, fmpz_mat_entry(lattice, 0, k));
    result.push_back(Rational::parse(text));
    flint_free(text);
  }
  fmpz_mat_clear(lattice);
  return result;
}

}  // namespace shortfall
