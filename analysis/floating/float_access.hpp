// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/floating/float_run_impl.hpp"

namespace shortfall {

/// A number of a format in pieces of 32 bits, the first ones the highest: sign * (pieces read as one whole
/// number) * 2^exponent.
struct BinaryPieces {
  bool negative = false;
  std::vector<std::uint32_t> pieces;
  long exponent = 0;
};

/// Of a dyadic rational.
BinaryPieces binary_pieces(const Rational& dyadic);

/// numerator * 2^exponent.
Rational scaled_by_two(const Rational& value, long exponent);

/// A number as a format stores it, or an infinity.
template <class T>
T stored_as(const Rational& value, const BinaryFormat& format, Rounding rounding, T infinity,
            const std::function<T(T, long)>& scaled) {
  const std::optional<Rational> r = rounded(value, format, rounding);
  if (!r) return value.sign() < 0 ? -infinity : infinity;
  const BinaryPieces p = binary_pieces(*r);
  T whole = T();
  for (std::uint32_t piece : p.pieces) whole = scaled(whole, 32) + T(piece);  // exact: within the precision
  whole = scaled(whole, p.exponent);
  return p.negative ? -whole : whole;
}

// One maker for each family of formats; each stands in a file of its own.
std::unique_ptr<FloatRun> small_float_run(const FloatFormat& format, const FloatQuestion& question);
std::unique_ptr<FloatRun> native_float_run(const FloatFormat& format, const FloatQuestion& question);
std::unique_ptr<FloatRun> wide_float_run(const FloatFormat& format, const FloatQuestion& question);
std::unique_ptr<FloatRun> small_tracked_run(const FloatFormat& format, const FloatQuestion& question);
std::unique_ptr<FloatRun> native_tracked_run(const FloatFormat& format, const FloatQuestion& question);

}  // namespace shortfall
