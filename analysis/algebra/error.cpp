// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/error.hpp"

#include <utility>

namespace shortfall {

SyntaxError::SyntaxError(std::string file, int line, int column, const std::string& what,
                         std::string source_line)
    : Error(file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + what),
      file_(std::move(file)),
      line_(line),
      column_(column),
      source_line_(std::move(source_line)) {
  while (!source_line_.empty() && (source_line_.back() == '\n' || source_line_.back() == '\r'))
    source_line_.pop_back();
}

std::string SyntaxError::context() const {
  if (source_line_.empty()) return {};
  std::string padding;
  int column = 1;
  for (const char c : source_line_) {
    // The second and later bytes of a UTF-8 character take no column of their own.
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;
    if (column >= column_) break;
    padding += c == '\t' ? '\t' : ' ';
    ++column;
  }
  return source_line_ + "\n" + padding + "^";
}

}  // namespace shortfall
