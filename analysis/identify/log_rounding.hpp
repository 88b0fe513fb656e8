// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "analysis/identify/log.hpp"

namespace shortfall {

/// Watches numbers as they were written, and says in the end how they were rounded.
class RoundingWatch {
 public:
  void see(std::string_view text, double value);
  LogRounding rounding() const;

 private:
  long seen_ = 0;
  long narrow_ = 0;           ///< those that a binary32 is written as
  int most_significant_ = 0;  ///< digits of the longest
  int most_decimals_ = 0;
  std::array<long, 32> decimals_{};  ///< how often so many digits stand after the point
};

}  // namespace shortfall
