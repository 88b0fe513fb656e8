// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <string>

namespace shortfall {

/// The text of whole / 10^places; places >= 0. "-0.0275" for -275 and 4; zero has no sign.
std::string decimal_text(const mpz_class& whole, int places);

/// The text of a number whose significant digits are those of `whole` (at least one) and whose leading digit
/// stands for 10^exponent; in the form 1.25e-09 outside [1e-6, 1e15).
std::string significant_text(const mpz_class& whole, long exponent);

mpz_class power_of_ten(unsigned long exponent);

/// throws  Error  when there are fewer digits than `least` or more than a million
void check_digits(int digits, int least);

}  // namespace shortfall
