// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shortfall {

/// One cell of a lesson, as it is written in its file: substitutions are still to be made.
struct LessonCell {
  enum class Kind {
    text,      ///< Markdown
    code,      ///< Python
    solution,  ///< Python that a pupil is to write; the answer stands between nbgrader's markers
    check,     ///< Python that gives points to the solution above
    answer,    ///< Markdown that a pupil is to write; a teacher gives the points
  };
  Kind kind = Kind::text;
  std::string name;   ///< of a solution, check or answer: unique among its kind
  std::string slide;  ///< slide, subslide, fragment, notes, skip; or empty
  int points = 0;     ///< of a check or an answer
  std::string source;
  int line = 0;  ///< where its source begins in its file
};

/// A lesson for a class: text, cells that assert what the text says, exercises with their solutions.
struct Lesson {
  std::string file;   ///< for messages
  std::string name;   ///< "falling-short"
  std::string title;  ///< "The jump that falls short"
  std::string about;  ///< one sentence
  int place = 0;      ///< in the course, from 1
  int minutes = 0;    ///< of class
  std::vector<LessonCell> cells;
};

/// Reads a .lesson file; the format is described in lessons/README.md.
///
/// throws  SyntaxError  with the line
Lesson parse_lesson(std::string_view text, const std::string& file);

/// The lessons that come with shortfall, in the order of the course.
const std::vector<Lesson>& lessons();

/// throws  BadInput  for an unknown name, with a suggestion
const Lesson& find_lesson(const std::string& name);

/// Who the notebook is for.
enum class LessonFor {
  teacher,  ///< with the answers, between nbgrader's markers
  pupil,    ///< without them
};

/// A lesson as a Jupyter notebook, with what shortfall derives put in. The same lesson gives the same bytes.
///
/// throws  SyntaxError  with the line of the cell, for a substitution that is not known or has no value
std::string notebook(const Lesson& lesson, LessonFor reader);

/// A page that goes with the notebook: what the lesson is about, what it needs, how it is run.
std::string lesson_readme(const Lesson& lesson, LessonFor reader);

}  // namespace shortfall
