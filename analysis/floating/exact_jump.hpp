// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <cstdint>
#include <vector>

#include "analysis/floating/exact_step.hpp"

namespace shortfall {

/// The monic polynomial of least degree with p(M) z = 0, lowest coefficient first; its coefficients are whole
/// because it divides the characteristic polynomial (Gauss's lemma).
std::vector<mpz_class> annihilator(const ExactStep& step, const std::vector<mpz_class>& z);

/// M^steps z: u^steps modulo the annihilator, by squaring, applied to z, M z, M^2 z, ...
///
/// throws  Unable  when numbers would be longer than kLongestExactNumber
std::vector<mpz_class> jumped(const ExactStep& step, const std::vector<mpz_class>& z, std::int64_t steps);

}  // namespace shortfall
