// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/program/expression.hpp"

namespace shortfall {

/// What nbgrader has to know about a cell of an exercise.
///
/// source  nbgrader, "Creating and grading assignments", metadata of schema version 3
struct GradedCell {
  std::string id;         ///< unique in the notebook
  bool solution = false;  ///< the pupil writes here
  bool grade = false;     ///< points are given here
  int points = 0;         ///< where they are given
};

/// A cell of a notebook.
struct NotebookCell {
  bool is_code = false;
  std::string what;  ///< a short word for the cell's id: letters, digits, hyphens
  std::string source;
  std::string slide = {};  ///< how it is shown as slides: slide, subslide, fragment, notes, skip; or empty
  std::optional<GradedCell> graded = {};
  std::string picture = {};  ///< a PNG that running the code would show; so it is seen without
};

/// A Jupyter notebook (format 4.5) as it grows: cells of text and of Python code.
///
/// The same cells give the same bytes; a cell's id is its number and what it was called.
class NotebookDocument {
 public:
  /// param   what  a short word for the cell's id: letters, digits, hyphens
  void text(const std::string& what, const std::string& markdown) { add({false, what, markdown}); }
  /// param   picture  see NotebookCell
  void code(const std::string& what, const std::string& python, const std::string& picture = {}) {
    add({true, what, python, {}, {}, picture});
  }
  void add(NotebookCell cell) { cells_.push_back(std::move(cell)); }

  /// The file.
  std::string json() const;

 private:
  std::vector<NotebookCell> cells_;
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
