// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

enum class Rounding { nearest_even, nearest_away, toward_zero, up, down };

/// A binary floating-point format: numbers m 2^e with |m| < 2^precision.
struct BinaryFormat {
  int precision = 53;        ///< bits, the leading one included
  long least_unit = -1074;   ///< all numbers, subnormals included, are multiples of 2^least_unit
  long greatest_bit = 1023;  ///< finite numbers are below 2^(greatest_bit + 1)

  static BinaryFormat binary16() { return {11, -24, 15}; }
  static BinaryFormat bfloat16() { return {8, -133, 127}; }
  static BinaryFormat binary32() { return {24, -149, 127}; }
  static BinaryFormat binary64() { return {53, -1074, 1023}; }
  static BinaryFormat x87() { return {64, -16445, 16383}; }
  static BinaryFormat binary128() { return {113, -16494, 16383}; }
  /// So many bits, with exponents that no computation here reaches.
  static BinaryFormat of_precision(int bits) { return {bits, -1'000'000'000L, 1'000'000'000L}; }

  Rational largest() const;   ///< finite number
  Rational smallest() const;  ///< positive number, a subnormal
  bool operator==(const BinaryFormat&) const = default;
};

/// The number of a format that stands for an exact one; none when it is infinite.
///
/// source  IEEE 754-2019, 4.3 (rounding-direction attributes): to nearest, what is 2^greatest_bit (2 -
/// 2^-precision) or more becomes infinite
std::optional<Rational> rounded(const Rational& value, const BinaryFormat& format,
                                Rounding rounding = Rounding::nearest_even);

/// How many bits a positive number has before the point, minus 1: 2^result <= value < 2^(result + 1).
long leading_bit(const Rational& value);

/// The exponent of the lowest bit of a dyadic number; none for 0.
///
/// throws  BadInput  when it is not dyadic
std::optional<long> lowest_bit(const Rational& value);

/// 2^exponent.
Rational power_of_two(long exponent);

}  // namespace shortfall
