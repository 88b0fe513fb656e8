// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// A number for which a decimal probably stands.
struct KnownNumber {
  std::string text;    ///< "1/3", "(3 - sqrt(3))/6"; "a root of 6 x^3 - 18 x^2 + 9 x - 1"
  int degree = 1;      ///< of its polynomial; an entry of a tableau may have 1 or 2
  double surplus = 0;  ///< decimal digits that agree beyond those which chance explains
};

/// The simplest rational, quadratic, cubic or quartic number that agrees with a decimal to its last digit, if
/// chance would not be expected to put one of its size there: p/q where 2 * 10^-digits * q^2 is small against
/// 1, polynomials of degree d and height H where (2 H)^(d+1) * 10^-digits is.
///
/// param   candidates  how many decimals are looked at: among many, one agrees by chance more often
std::optional<KnownNumber> known_number(const Rational& decimal, int digits, int candidates);

}  // namespace shortfall
