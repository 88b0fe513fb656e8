// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

/// Reads the statements of a start, step or finish block, braces included.
class StatementReader {
 public:
  struct Opened {
    Place place;
    std::string word;  ///< "substeps", "when"
  };

  /// From here on statements go to this block.
  ///
  /// param   in_step  whether it is the step: substeps, when and limit stand there only
  void begin(std::vector<Statement>& block, bool in_step);
  /// Reads one statement.
  ///
  /// param   word  its first word; empty when that is assigned
  /// throws  SyntaxError
  void read(TokenReader& in, const std::string& word);
  /// The innermost braces that are open; nullptr when there are none.
  const Opened* open() const { return opened_.empty() ? nullptr : &opened_.back(); }

 private:
  void read_assignment(TokenReader& in);
  void read_solve(TokenReader& in);
  void read_limit(TokenReader& in);
  void open_substeps(TokenReader& in);
  void open_when(TokenReader& in);
  void open_braces(Statement s, TokenReader& in, const std::string& where);
  void close_braces(TokenReader& in);

  bool in_step_ = false;
  std::vector<std::vector<Statement>*> blocks_;
  std::vector<Opened> opened_;
};

}  // namespace shortfall
