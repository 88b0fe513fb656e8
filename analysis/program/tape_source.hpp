// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/program/tape.hpp"

namespace shortfall {

/// Where the instructions of a tape come from. It is held beside the tape, which therefore is as small and as
/// fast as without; it knows the instructions by their addresses, so the tape may be moved, not copied.
class TapeSource {
 public:
  /// The statement that an instruction of start, step or finish belongs to (without its body); null for what
  /// belongs to none, and inside a solve.
  const Statement* statement_of(const Instruction& i) const;

  int add(const Statement& s);
  /// param   statements  one for each instruction of a block that is complete; -1 for none
  void note(const Block& block, const std::vector<int>& statements);

 private:
  std::vector<Statement> statements_;
  std::unordered_map<const Instruction*, int> statement_;
};

/// A tape as `lower` makes it, and where its instructions come from.
///
/// throws  as `lower` does
std::pair<Tape, TapeSource> lower_with_source(const Program& program, const Values& given = {});

/// A statement as it is written, on one line: "x = x + h*v"; of one with a body the head.
std::string print(const Statement& s);

}  // namespace shortfall
