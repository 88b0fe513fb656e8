// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/floating/binary_format.hpp"

namespace shortfall {

/// An arithmetic that a step can run in: a format, and how it is used.
struct FloatFormat {
  enum class Kind { binary16, bfloat16, binary32, binary64, x87, binary128, double_double, mpfr };
  enum class Variant {
    plain,
    fused,        ///< +fma: a product that is added to something is not rounded by itself
    compensated,  ///< +kahan: what an addition rounds off is given to the next
    offset,       ///< +origin: binary32 offsets from a binary64 origin
    toward_zero,  ///< +tozero: every operation is rounded toward zero
  };
  Kind kind = Kind::binary64;
  Variant variant = Variant::plain;
  int digits = 0;  ///< of mpfr, decimal

  std::string name() const;   ///< "f32+kahan", "mpfr:50"
  std::string words() const;  ///< "binary32, compensated"
  /// What constants are stored in. For double-double its 106 bits are those of the high part's exponent.
  BinaryFormat storage() const;
  Rounding rounding() const {
    return variant == Variant::toward_zero ? Rounding::toward_zero : Rounding::nearest_even;
  }
  bool operator==(const FloatFormat&) const = default;
};

/// "f16", "bf16", "f32", "f64", "x87", "f128", "dd", "mpfr:50", each with "+fma", "+kahan", "+origin" (f32
/// only) or "+tozero" where that is defined; "float", "double", "half", "quad" are other words for some.
///
/// throws  BadInput  for an unknown name, with a suggestion
FloatFormat float_format(std::string_view name);

/// Several, separated by commas.
std::vector<FloatFormat> float_formats(std::string_view names);

}  // namespace shortfall
