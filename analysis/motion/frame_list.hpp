// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// How long the frames of a game took, as somebody recorded them.  The format is described in docs/frames.md.
struct FrameList {
  /// What a row of the file states.
  enum class Kind { step, stamp, rate };

  std::string file;
  Kind kind = Kind::step;
  std::string column;           ///< the header of the column that was read; empty without a header
  std::string unit = "s";       ///< of the numbers that come without one
  bool unit_is_given = false;   ///< whether the file says the unit; otherwise seconds (or Hz) are assumed
  std::vector<Rational> steps;  ///< seconds, each greater than 0, exactly as written
  int last_line = 1;            ///< of the last row, from 1

  Rational duration() const;  ///< seconds, all of them together
  bool equal() const;         ///< whether all steps have the same length
};

inline constexpr std::size_t kMostFrames = 1'000'000;

/// One column of steps, or a table with a header; commas, semicolons or tabs between columns, # begins a
/// comment.
///
/// throws  SyntaxError  with line and column: no number, a step that is not positive, a time stamp that does
/// not advance, no step at all, no text, more than kMostFrames rows
FrameList parse_frames(std::string_view text, const std::string& file);

/// throws  UnreadableFile, SyntaxError
FrameList read_frames(const std::string& path);

}  // namespace shortfall
