// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/real.hpp"

#include "analysis/algebra/decimal.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {
namespace {

template <class Number>
unsigned default_digits() {
  if constexpr (requires { Number::thread_default_precision(); })
    return Number::thread_default_precision();
  else
    return Number::default_precision();
}

template <class Number>
void set_default_digits(unsigned digits) {
  if constexpr (requires { Number::thread_default_precision(digits); })
    Number::thread_default_precision(digits);
  else
    Number::default_precision(digits);
}

}  // namespace

Precision::Precision(int digits) : saved_(current()) {
  check_digits(digits, 1);
  set_default_digits<Real>(static_cast<unsigned>(digits));
}

Precision::~Precision() { set_default_digits<Real>(static_cast<unsigned>(saved_)); }

int Precision::current() { return static_cast<int>(default_digits<Real>()); }

Real real(const Rational& value, int digits) {
  check_digits(digits, 1);
  Real result;
  result.precision(static_cast<unsigned>(digits));
  const mpq_class exact = gmp(value);
  mpfr_set_q(result.backend().data(), exact.get_mpq_t(), MPFR_RNDN);
  return result;
}

Real real(const Surd& value, int digits) {
  if (value.is_rational()) return real(value.rational_part(), digits);
  check_digits(digits, 1);
  // An irrational number is never half way between two others, so bounds round alike at last.
  for (int extra = 10;; extra *= 2) {
    const Rational near = value.approximation(digits + extra);
    const Rational width = near.abs() * Rational(10).pow(-digits - extra) * 2;
    Real low = real(near - width, digits);
    if (low == real(near + width, digits)) return low;
  }
}

}  // namespace shortfall
