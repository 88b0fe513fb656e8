// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "notebooks-export/base64.hpp"
#include "notebooks-export/lesson.hpp"
#include "notebooks-export/lesson_data.hpp"
#include "notebooks-export/lesson_value.hpp"
#include "notebooks-export/notebook_document.hpp"

namespace shortfall {

namespace {

using Kind = LessonCell::Kind;

/// Every {{words}} replaced by what it stands for.
std::string substituted(const Lesson& lesson, const LessonCell& cell) {
  std::string result;
  std::size_t at = 0;
  for (;;) {
    const std::size_t open = cell.source.find("{{", at);
    result += cell.source.substr(at, open - at);
    if (open == std::string::npos) return result;
    const std::size_t close = cell.source.find("}}", open);
    const std::string words = cell.source.substr(open + 2, close - open - 2);
    const int line =
        cell.line + static_cast<int>(std::count(
                        cell.source.begin(), cell.source.begin() + static_cast<std::ptrdiff_t>(open), '\n'));
    if (close == std::string::npos)
      throw SyntaxError(lesson.file, line, 1, "'{{' is not closed in this cell");
    try {
      result += lesson_value(words);
    } catch (const Error& e) {
      throw SyntaxError(lesson.file, line, 1, "{{" + words + "}}: " + e.what());
    }
    at = close + 2;
  }
}

/// The text with what stands between the markers replaced by a place for the pupil's own.
std::string without_answer(const std::string& source, bool is_code) {
  std::istringstream lines(source);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("### BEGIN SOLUTION") != std::string::npos) {
      inside = true;
      const std::string blanks = line.substr(0, line.find('#'));
      text += is_code ? blanks + "# YOUR CODE HERE\n" + blanks + "raise NotImplementedError()\n"
                      : "YOUR ANSWER HERE\n";
    } else if (line.find("### END SOLUTION") != std::string::npos) {
      inside = false;
    } else if (!inside) {
      text += line + "\n";
    }
  }
  return text;
}

/// What the cell that draws showed when the lesson was last drawn (`./dev pictures`).
std::string drawn(const std::string& lesson, int number) {
  return from_hexadecimal(embedded_text(lesson_pictures(), lesson + "-" + std::to_string(number) + ".png"));
}

const char* word(Kind kind) {
  switch (kind) {
    case Kind::solution:
      return "solution";
    case Kind::check:
      return "check";
    case Kind::answer:
      return "answer";
    case Kind::code:
      return "code";
    default:
      return "text";
  }
}

}  // namespace

std::string notebook(const Lesson& lesson, LessonFor reader) {
  NotebookDocument document;
  int drawing = 0;
  for (const LessonCell& cell : lesson.cells) {
    const bool is_code = cell.kind != Kind::text && cell.kind != Kind::answer;
    const std::string what = cell.name.empty() ? word(cell.kind) : word(cell.kind) + ("-" + cell.name);
    NotebookCell made{is_code, what, substituted(lesson, cell), cell.slide};
    if (cell.kind == Kind::code && cell.source.find("plt.show()") != std::string::npos)
      made.picture = drawn(lesson.name, ++drawing);
    if (!cell.name.empty())
      made.graded = GradedCell{what, cell.kind != Kind::check, cell.kind != Kind::solution, cell.points};
    if (made.graded && made.graded->solution && reader == LessonFor::pupil)
      made.source = without_answer(made.source, is_code);
    document.add(std::move(made));
  }
  return document.json();
}

std::string lesson_readme(const Lesson& lesson, LessonFor reader) {
  const std::string file = lesson.name + ".ipynb";
  std::string text = "# " + lesson.title + "\n\n" + lesson.about + "\n\n";
  text += "About " + std::to_string(lesson.minutes) + " minutes of class, lesson " +
          std::to_string(lesson.place) + " of " + std::to_string(lessons().size()) + ".\n\n";
  text += "    jupyter lab " + file + "\n    jupyter nbconvert --to slides " + file + "\n\n";
  text +=
      "Python 3 is enough: the cells compute with its own fractions. Where matplotlib is installed they "
      "draw, "
      "too. Every claim is asserted in a cell; run all of them, and one that is wrong stops the notebook "
      "there.\n\n";
  text += reader == LessonFor::pupil
              ? "This is the pupil's copy: the cells that say YOUR CODE HERE and YOUR ANSWER HERE are yours, "
                "and the "
                "locked cells below them check what you wrote.\n"
              : "This is the teacher's copy. The answers stand between nbgrader's markers; `shortfall export "
                "lesson:" +
                    lesson.name +
                    " --exercise` leaves them out, and so does `nbgrader generate_assignment`.\n";
  return text + "\nWritten by shortfall. Licence: GPL-3.0-or-later.\n";
}

}  // namespace shortfall
