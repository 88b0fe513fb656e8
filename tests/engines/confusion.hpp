// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/engines/recording.hpp"

namespace shortfall::engines {

/// What is left of a recording before `identify` sees it.
struct Blur {
  int decimals = -1;  ///< positions and velocities rounded to so many; -1: all bits
  bool velocities = true;
};

/// What `identify` answered, and what the recording's manifest says about that.
struct Verdict {
  enum class Kind {
    identified,  ///< one map, and it is the true one
    undecided,   ///< several maps, the true one among them
    as_such,     ///< no map of the family made it, and that is the answer
    missed,      ///< no map is listed, though one made it
    wrong,       ///< maps are listed, and the true one is not among them
    refused,     ///< a sentence says why nothing can be told
  };
  Kind kind = Kind::missed;
  std::string file, engine;
  std::string answer;  ///< the first maps that were listed
  std::size_t listed = 0;
  std::size_t unfaithful = 0;  ///< maps that are listed and do not reproduce the log when they are run again
  double seconds = 0;
};

/// Runs `identify` on the positions alone that the CSV holds; only the verdict reads the manifest.
Verdict verdict(const Recording& recording, const std::string& csv, const Blur& blur);

/// A line for each engine; below, what is wrong or missed.
std::string confusion_table(const std::vector<Verdict>& verdicts);

}  // namespace shortfall::engines
