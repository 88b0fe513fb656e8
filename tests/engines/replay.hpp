// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "tests/engines/recording.hpp"

namespace shortfall::engines {

/// What came out when an engine's frame, as the catalogue has it, was run beside a recording of the engine.
struct Outcome {
  std::string file;
  std::string engine;
  std::string integrator;  ///< empty when the recording shows something else than the engine's integrator
  bool claimed = false;
  bool exact = false;  ///< every row agrees to the last bit
  std::size_t rows = 0;
  std::optional<std::size_t> first_difference;  ///< the first frame that differs
  std::string reason;                           ///< why it is not exact; empty when it is
};

/// Runs the engine's frame in the engine's own precision, from the recorded frame 0 on.
///
/// throws  BadInput  for an engine or a precision that is not known
Outcome replay(const Recording& recording);

/// Runs another program in place of the engine's own.
Outcome replay(const Recording& recording, const Program& program);

/// The name in the catalogue of the engine that was recorded.
///
/// throws  BadInput  for an engine that is not known
std::string integrator_of(const Recording& recording);

/// The outcomes engine by engine, and below, what is not exact and why.
std::string table(const std::vector<Outcome>& outcomes);

}  // namespace shortfall::engines
