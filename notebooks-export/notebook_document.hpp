// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// A Jupyter notebook (format 4.5) as it grows: cells of text and of Python code.
///
/// The same cells give the same bytes; a cell's id is its number and what it was called.
class NotebookDocument {
 public:
  /// param   what  a short word for the cell's id: letters, digits, hyphens
  void text(const std::string& what, const std::string& markdown) {
    cells_.push_back({false, what, markdown});
  }
  void code(const std::string& what, const std::string& python) { cells_.push_back({true, what, python}); }

  /// The file.
  std::string json() const;

 private:
  struct Cell {
    bool is_code;
    std::string what;
    std::string source;
  };
  std::vector<Cell> cells_;
};

/// Text of a user's file, so that Markdown shows it as it stands.
std::string markdown_escaped(const std::string& text);

/// left = right as a displayed equation; one that is too long for a page is broken at its terms.
std::string displayed(const Expr& left, const Expr& right);

/// An expression as a displayed formula, broken in the same way.
std::string displayed(const Expr& e);
/// Whether it is too long to stand within a line.
bool is_long(const Expr& e);

/// An expression within a line: $...$.
std::string inlined(const Expr& e);

/// A sentence of ours: a capital at its beginning, a full stop at its end.
std::string sentence(const std::string& text);

}  // namespace shortfall
