// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Of the library's own files only exact_*.cpp include this: GMP stays behind them.

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <vector>

namespace shortfall {

/// A matrix of 2 by 2 words applied to two long integers in a single pass over their limbs, in place.
class ExactPair {
 public:
  /// Whether it is 2 by 2 and each entry is below 2^61 in size: then two products and a carry fit into 127
  /// bits.
  static bool fits(const std::vector<std::vector<mpz_class>>& matrix);
  explicit ExactPair(const std::vector<std::vector<mpz_class>>& matrix);

  void apply(std::vector<mpz_class>& z) const;

  /// Beside ExactPlan::cost, as measured.
  static constexpr double kCost = 3.2;

 private:
  std::array<std::int64_t, 4> entries_;  ///< row by row
};

}  // namespace shortfall
