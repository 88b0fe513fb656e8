// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/real.hpp"
#include "analysis/floating/double_double.hpp"

namespace shortfall {

// What the power series need of their numbers besides + - * / and the functions.

inline double rough(const DoubleDouble& a) { return a.high(); }
inline double rough(const Real& a) { return a.convert_to<double>(); }

/// sum += a b.
inline void add_product(DoubleDouble& sum, const DoubleDouble& a, const DoubleDouble& b) {
  sum = sum + a * b;
}
inline void add_product(Real& sum, const Real& a, const Real& b) {
  // In place: no number is made and thrown away.
  mpfr_fma(sum.backend().data(), a.backend().data(), b.backend().data(), sum.backend().data(), MPFR_RNDN);
}

}  // namespace shortfall
