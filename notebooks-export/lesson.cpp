// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/lesson.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/program/suggest.hpp"
#include "notebooks-export/lesson_data.hpp"

namespace shortfall {

namespace {

using Kind = LessonCell::Kind;

const std::vector<std::pair<std::string, Kind>> kKinds{{"text", Kind::text},
                                                       {"code", Kind::code},
                                                       {"solution", Kind::solution},
                                                       {"check", Kind::check},
                                                       {"answer", Kind::answer}};
const std::vector<std::string> kSlides{"slide", "subslide", "fragment", "notes", "skip"};
const std::vector<std::string> kHeads{"lesson", "title", "about", "place", "minutes"};

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text) { lesson_.file = file; }

  Lesson lesson() {
    std::istringstream lines{std::string(text_)};
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      if (line.starts_with("%%"))
        begin(line);
      else if (lesson_.cells.empty())
        head(line);
      else
        lesson_.cells.back().source += line + "\n";
    }
    finish();
    if (lesson_.name.empty() || lesson_.title.empty() || lesson_.about.empty())
      fail("a lesson needs the lines 'lesson NAME', 'title ...' and 'about ...' before its first cell");
    if (lesson_.cells.empty()) fail("a lesson needs a cell: a line '%% text' begins one");
    return std::move(lesson_);
  }

 private:
  [[noreturn]] void fail(const std::string& what, int line = 0) const {
    throw SyntaxError(lesson_.file, line ? line : std::max(line_, 1), 1, what);
  }

  int whole(const std::string& text, const std::string& of) const {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > 1000)
      fail("'" + of + "' wants a whole number from 1 to 1000, not '" + text + "'");
    return value;
  }

  void head(const std::string& line) {
    if (line.empty() || line.starts_with('#')) return;
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::string word = line.substr(0, blank);
    const std::size_t begin = line.find_first_not_of(' ', blank);
    const std::string rest = begin == std::string::npos ? "" : line.substr(begin);
    if (std::ranges::find(kHeads, word) == kHeads.end())
      fail("unknown word '" + word + "'" + did_you_mean(word, kHeads));
    if (rest.empty()) fail("'" + word + "' wants a text");
    if (word == "lesson") lesson_.name = rest;
    if (word == "title") lesson_.title = rest;
    if (word == "about") lesson_.about = rest;
    if (word == "place") lesson_.place = whole(rest, word);
    if (word == "minutes") lesson_.minutes = whole(rest, word);
  }

  /// %% KIND [NAME] [slide|subslide|...] [points=N]
  void begin(const std::string& line) {
    finish();
    std::istringstream words(line.substr(2));
    std::string word;
    words >> word;
    const auto kind = std::ranges::find(kKinds, word, &std::pair<std::string, Kind>::first);
    if (kind == kKinds.end()) {
      std::vector<std::string> names;
      for (const auto& [name, of] : kKinds) names.push_back(name);
      fail("unknown kind of cell '" + word + "'" + did_you_mean(word, names));
    }
    LessonCell cell{.kind = kind->second, .name = {}, .slide = {}, .source = {}, .line = line_};
    const bool named = cell.kind != Kind::text && cell.kind != Kind::code;
    while (words >> word) {
      if (std::ranges::find(kSlides, word) != kSlides.end())
        cell.slide = word;
      else if (word.starts_with("points="))
        cell.points = whole(word.substr(7), "points");
      else if (named && cell.name.empty())
        cell.name = word;
      else
        fail("'" + word + "' says nothing about a cell" + did_you_mean(word, kSlides));
    }
    if (named && cell.name.empty()) fail("a cell '" + kind->first + "' wants a name");
    const bool graded = cell.kind == Kind::check || cell.kind == Kind::answer;
    if (graded != (cell.points > 0))
      fail(graded ? "a cell '" + kind->first + "' wants points=N"
                  : "points are given by 'check' and 'answer'");
    if (named && !names_.insert(kind->first + " " + cell.name).second)
      fail("there are two cells '" + kind->first + " " + cell.name + "'");
    lesson_.cells.push_back(std::move(cell));
  }

  /// Of the cell that has been read: without blank lines around it.
  void finish() {
    if (lesson_.cells.empty()) return;
    LessonCell& cell = lesson_.cells.back();
    std::string& s = cell.source;
    const std::size_t blank = std::min(s.find_first_not_of('\n'), s.size());
    s.erase(0, blank);
    while (s.ends_with('\n')) s.pop_back();
    if (s.empty()) fail("this cell is empty", cell.line);
    if (cell.kind == Kind::solution || cell.kind == Kind::answer) {
      const std::size_t begin = s.find("### BEGIN SOLUTION");
      const std::size_t end = s.find("### END SOLUTION");
      if (begin == std::string::npos || end == std::string::npos || end < begin)
        fail("the answer stands between the lines '### BEGIN SOLUTION' and '### END SOLUTION'", cell.line);
    } else if (s.find("### BEGIN SOLUTION") != std::string::npos) {
      fail("only cells 'solution' and 'answer' hold an answer", cell.line);
    }
    cell.line += 1 + static_cast<int>(blank);  // from now on that of its first words
  }

  std::string_view text_;
  Lesson lesson_;
  std::set<std::string> names_;
  int line_ = 0;
};

}  // namespace

Lesson parse_lesson(std::string_view text, const std::string& file) { return Reader(text, file).lesson(); }

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> course = [] {
    std::vector<Lesson> all;
    for (const EmbeddedFile& file : lesson_files())
      all.push_back(parse_lesson(file.text, "lessons/" + std::string(file.path)));
    std::ranges::sort(all, {}, &Lesson::place);
    return all;
  }();
  return course;
}

const Lesson& find_lesson(const std::string& name) {
  std::vector<std::string> names;
  for (const Lesson& lesson : lessons()) {
    if (lesson.name == name) return lesson;
    names.push_back(lesson.name);
  }
  throw BadInput("unknown lesson '" + name + "'" + did_you_mean(name, names) +
                 " (shortfall export --lessons lists them)");
}

}  // namespace shortfall
