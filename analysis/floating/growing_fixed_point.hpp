// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp and this one's include it: GMP stays behind them.

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace shortfall {

/// N 2^-(64 fraction) with N a whole number in two's complement: a binary fixed point that gets digits at its
/// low end when they are needed, so that numbers of different lengths are added without shifting either.
///
/// Numbers that meet in an operation have the same number of limbs above the point, of which the highest is
/// only a sign before the operation.
class GrowingFixedPoint {
 public:
  GrowingFixedPoint() = default;
  /// value 2^-places, with at least so many limbs above the point.
  GrowingFixedPoint(const mpz_class& value, std::int64_t places, std::size_t whole);

  std::size_t fraction() const { return fraction_; }
  std::size_t whole() const { return size() - fraction_; }
  std::size_t size() const { return high_ - low_; }
  bool negative() const { return (limbs_[high_ - 1] >> (GMP_NUMB_BITS - 1)) != 0; }
  int sign() const;
  /// Whether the highest limb is a sign and nothing else.
  bool has_guard() const;

  void widen();  ///< by one limb above the point
  void clear();  ///< to 0, with the limbs above the point that it has
  /// this += or -= word 2^-(64 down) other, modulo what the limbs above the point hold.
  void add_product(const GrowingFixedPoint& other, mp_limb_t word, std::size_t down, bool subtract);
  void trim();  ///< zeros at the low end are dropped

  mpz_class numerator() const;  ///< N
  /// N's `limbs` leading limbs, rounded down; the others, of which there were `dropped`, are below 1.
  mpz_class leading(std::size_t limbs, std::size_t& dropped) const;

 private:
  void prepend(std::size_t limbs);

  std::vector<mp_limb_t> limbs_;    // the lowest first, with room at both ends
  std::size_t low_ = 0, high_ = 0;  // those in use
  std::size_t fraction_ = 0;        // of them below the point
};

}  // namespace shortfall
