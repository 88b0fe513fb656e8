// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "analysis/floating/binary_format.hpp"

namespace shortfall {

/// The arithmetic that a clock adds in.
struct ClockArithmetic {
  BinaryFormat format = BinaryFormat::binary32();
  std::string format_name = "f32";  ///< "f64", "mpfr:50", "fixed:23"
  std::string words = "binary32 (float)";
  Rounding rounding = Rounding::nearest_even;
  bool fused = false;        ///< v dt is not rounded before it is added
  bool compensated = false;  ///< Kahan's sum
  bool fixed_point = false;  ///< multiples of one unit in a 64-bit word
};

/// A format of `float_format`, with +fma, +kahan or +tozero; or "fixed:B", the multiples of 2^-B in a signed
/// 64-bit word.
///
/// throws  BadInput  for an unknown name, with a suggestion
/// throws  Unable    for double-double and for offsets from an origin, which are no binary format
ClockArithmetic clock_arithmetic(std::string_view name);

/// "nearest-even", "nearest-away", "toward-zero", "up", "down".
///
/// throws  BadInput  for another word, with a suggestion
Rounding rounding_named(std::string_view name);

std::string name_of(Rounding rounding);

}  // namespace shortfall
