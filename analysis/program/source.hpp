// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// A text cut into lines, which knows how to complain about a place in itself.
class Source {
 public:
  static constexpr std::size_t kLongestLine = 10'000;

  /// param   longest_line  how many bytes a line may have
  /// throws  SyntaxError  when the text is no text (NUL bytes, broken UTF-8), larger than 1 MB, or has a line
  /// that is too long
  Source(std::string file, std::string_view text, std::size_t longest_line = kLongestLine);

  const std::string& file() const { return file_; }
  int line_count() const { return static_cast<int>(lines_.size()); }
  const std::string& line(int number) const { return lines_[number - 1]; }
  /// The place of a byte of a line, columns counted in characters.
  Place place(int line, std::size_t byte) const;
  SyntaxError error(Place place, const std::string& what) const;

 private:
  std::string file_;
  std::vector<std::string> lines_;
  std::vector<std::size_t> plain_;  ///< of each line, how many bytes at its beginning are one character each
};

/// The beginning of a text, for a message that quotes it.
std::string shortened(std::string_view text);

}  // namespace shortfall
