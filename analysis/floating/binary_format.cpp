// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/floating/binary_format.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/gmp.hpp"

namespace shortfall {

Rational power_of_two(long exponent) { return Rational(2).pow(static_cast<int>(exponent)); }

long leading_bit(const Rational& value) {
  const mpz_class above = gmp_numerator(value), below = gmp_denominator(value);
  const long guess = bit_length(above) - bit_length(below);
  const bool too_high = guess >= 0 ? above < (below << static_cast<unsigned long>(guess))
                                   : (above << static_cast<unsigned long>(-guess)) < below;
  return too_high ? guess - 1 : guess;
}

std::optional<long> lowest_bit(const Rational& value) {
  if (value.is_zero()) return std::nullopt;
  const mpz_class above = gmp_numerator(value), below = gmp_denominator(value);
  if (mpz_popcount(below.get_mpz_t()) != 1) throw BadInput("an increment is a multiple of a power of two");
  return static_cast<long>(mpz_scan1(above.get_mpz_t(), 0)) - (bit_length(below) - 1);
}

namespace {

/// Whether a positive number between two neighbours goes to the upper one in size.
bool goes_up(const Rational& rest, const Rational& whole, bool negative, Rounding rounding) {
  switch (rounding) {
    case Rounding::toward_zero:
      return false;
    case Rounding::up:
      return !negative && !rest.is_zero();
    case Rounding::down:
      return negative && !rest.is_zero();
    case Rounding::nearest_even:
    case Rounding::nearest_away:
      break;
  }
  const Rational half(1, 2);
  if (rest != half) return rest > half;
  return rounding == Rounding::nearest_away || !(whole / Rational(2)).is_integer();
}

}  // namespace

Rational BinaryFormat::largest() const {
  return (Rational(2) - power_of_two(1 - precision)) * power_of_two(greatest_bit);
}

Rational BinaryFormat::smallest() const { return power_of_two(least_unit); }

std::optional<Rational> rounded(const Rational& value, const BinaryFormat& format, Rounding rounding) {
  if (value.is_zero()) return value;
  const bool negative = value.sign() < 0;
  const Rational size = value.abs();
  const long unit = std::max(leading_bit(size) - (format.precision - 1), format.least_unit);
  const Rational one = power_of_two(unit);
  const Rational whole = (size / one).floor();
  const Rational rest = size / one - whole;
  Rational result = (goes_up(rest, whole, negative, rounding) ? whole + Rational(1) : whole) * one;
  if (leading_bit(size) > format.greatest_bit ||
      (!result.is_zero() && leading_bit(result) > format.greatest_bit)) {
    const bool stays_finite = rounding == Rounding::toward_zero || (rounding == Rounding::up && negative) ||
                              (rounding == Rounding::down && !negative);
    if (!stays_finite) return std::nullopt;
    result = format.largest();
  }
  return negative ? -result : result;
}

}  // namespace shortfall
