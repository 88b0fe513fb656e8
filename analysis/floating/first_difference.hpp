// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/floating/float_run.hpp"

namespace shortfall {

/// Where a run in a format first is not the exact map of its constants.
struct FirstDifference {
  /// The first vector that a statement makes, and that is not what exact arithmetic makes of the same state:
  /// before it there is no rounding that could matter.
  struct Rounding {
    std::int64_t step = 0;  ///< counted from 1; 0 in `start`
    int line = 0;           ///< of the file; 0 when the statement stands in none
    std::string statement;  ///< "x = x + h*v"
    bool read_out = false;  ///< in `finish`, after that step
  };
  std::int64_t compared = 0;               ///< steps
  std::optional<Rounding> rounding{};      ///< none when every vector was exact
  std::optional<std::int64_t> reported{};  ///< the first step after which x or v as reported is not exact
};

/// Both are run statement by statement, until x or v as reported differ. As long as they agree, exact numbers
/// are as short as the run's.
///
/// param   stored  the question with its numbers as the format stores them
/// param   most    steps
/// throws  Unable  when the step has an irrational coefficient, so that there is no exact run
FirstDifference first_difference(const FloatFormat& format, const FloatQuestion& question,
                                 const FloatQuestion& stored, std::int64_t most);

}  // namespace shortfall
