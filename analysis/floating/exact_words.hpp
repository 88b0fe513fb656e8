// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/algebra/wide.hpp"

namespace shortfall {

/// z(n+1) = M z(n) in words of 64 and 128 bits, as long as it is certain that nothing overflows.
///
/// Before a run of 2^i steps max(|M|, 1)^(2^i) |z|, in upper bounds, is held against the word: so the steps
/// themselves are not checked.
class ExactWords {
 public:
  /// param   matrix  row by row
  ExactWords(std::vector<std::int64_t> matrix, std::vector<Int128> start);

  /// Makes up to so many steps; how many it made. Fewer: the next one might overflow 128 bits.
  std::int64_t advance(std::int64_t steps);

  const std::vector<Int128>& state() const { return state_; }

 private:
  std::vector<std::int64_t> matrix_;
  std::vector<Int128> state_;
  std::vector<std::vector<double>> growth_;  ///< upper bounds of max(|M|, 1)^(2^i)
};

}  // namespace shortfall
