// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/frame_list.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/frame_header.hpp"
#include "analysis/program/utf8.hpp"

namespace shortfall {

namespace {

using Kind = FrameList::Kind;

constexpr std::size_t kLargestFile = 64'000'000;
constexpr std::size_t kLongestLine = 10'000;
constexpr std::size_t kLongestShown = 400;  // a longer line and its caret would only fill the screen
constexpr std::size_t kMostDigits = 100;

constexpr std::string_view kBlanks = " \t";

/// A part of a line and where it begins, in bytes.
struct Cell {
  std::string_view text;
  std::size_t begin = 0;
};

Cell trimmed(Cell cell) {
  const std::size_t first = cell.text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {{}, cell.begin};
  cell.text.remove_prefix(first);
  cell.begin += first;
  cell.text = cell.text.substr(0, cell.text.find_last_not_of(kBlanks) + 1);
  if (cell.text.size() >= 2 && cell.text.front() == '"' && cell.text.back() == '"')
    return trimmed({cell.text.substr(1, cell.text.size() - 2), cell.begin + 1});
  return cell;
}

bool number_like(std::string_view text) {
  if (text.empty()) return false;
  const char first = text.front();
  if ((first >= '0' && first <= '9') || first == '+' || first == '-' || first == '.') return true;
  std::string word;
  for (char c : text) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word == "nan" || word == "inf" || word == "infinity";
}

std::string in_quotes(std::string_view text) {
  return "'" + std::string(text.substr(0, 60)) + (text.size() > 60 ? "..." : "") + "'";
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text) { list_.file = file; }

  FrameList frames() {
    check_text();
    for (std::size_t begin = 0; begin < text_.size();) {
      std::size_t end = text_.find_first_of("\r\n", begin);
      if (end == std::string_view::npos) end = text_.size();
      line_ = text_.substr(begin, end - begin);
      ++number_;
      row();
      begin = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
    }
    if (list_.steps.empty()) nothing();
    return std::move(list_);
  }

 private:
  [[noreturn]] void complain(std::size_t byte, const std::string& what) const {
    const std::string_view before = line_.substr(0, byte);
    const auto column = std::ranges::count_if(before, [](char c) { return (c & 0xC0) != 0x80; }) + 1;
    throw SyntaxError(list_.file, std::max(number_, 1), static_cast<int>(column), what,
                      line_.size() <= kLongestShown ? std::string(line_) : std::string());
  }

  /// Refuses what is no text before a byte of it can reach a terminal.
  void check_text() {
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
      throw SyntaxError(list_.file, 1, 1, "the file is in UTF-16; save it as UTF-8 or plain ASCII");
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // a byte order mark
    int line = 1;
    std::size_t begin = 0;
    for (std::size_t i = 0, length = 1; i < text_.size(); i += length) {
      const auto c = static_cast<unsigned char>(text_[i]);
      length = utf8_length(text_, i);
      if (c == '\n' || c == '\r') {
        if (c == '\n' || !text_.substr(i).starts_with("\r\n")) ++line;
        begin = i + 1;
      } else if ((c < 0x20 && c != '\t') || c == 0x7F || length == 0) {
        throw SyntaxError(list_.file, line, static_cast<int>(std::min(i - begin, kLongestLine)) + 1,
                          length == 0 ? "this is no UTF-8 text (a binary file?)"
                                      : "this is no text: it has a control character in it (a binary file?)");
      } else if (i - begin >= kLongestLine) {
        throw SyntaxError(list_.file, line, 1, "the line is longer than 10,000 bytes");
      }
    }
  }

  [[noreturn]] void nothing() const {
    const std::string where = list_.column.empty() ? "" : "below the header " + in_quotes(list_.column) + " ";
    throw SyntaxError(
        list_.file, std::max(number_, 1), 1,
        last_ ? "one time stamp is no step: " + where + "there must be at least two"
              : "there is no step in it: " + where + (where.empty() ? "the file is empty" : "is no row"));
  }

  void row() {
    std::vector<Cell> cells = split();
    if (cells.empty()) return;
    if (!begun_) {
      begun_ = true;
      if (std::ranges::none_of(cells, [](const Cell& c) { return number_like(c.text); })) {
        header(cells);
        return;
      }
      if (cells.size() > 1)
        complain(cells[1].begin,
                 "there are " + std::to_string(cells.size()) +
                     " columns and no header that says which one is the step; write a line such as 'frame,dt "
                     "[ms]' or 'frame,time [s]' above them");
    }
    if (place_ >= cells.size())
      complain(line_.size(), "the row has " + std::to_string(cells.size()) + " of the " +
                                 std::to_string(place_ + 1) + " cells up to the column " +
                                 in_quotes(list_.column));
    if (list_.column.empty() && cells.size() > 1)
      complain(cells[1].begin, "the row has " + std::to_string(cells.size()) +
                                   " cells, the ones above have 1; a decimal point is a point");
    take(cells[place_]);
    list_.last_line = number_;
  }

  /// The cells of a line without its comment; none for a line that has nothing to say.
  std::vector<Cell> split() {
    std::size_t end = 0;
    bool quotes = false;
    for (; end < line_.size() && (quotes || line_[end] != '#'); ++end)
      if (line_[end] == '"') quotes = !quotes;
    const std::string_view content = line_.substr(0, end);
    if (content.find_first_not_of(kBlanks) == std::string_view::npos) return {};
    if (!begun_)
      for (const char candidate : {',', ';', '\t'})
        if (content.find(candidate) != std::string_view::npos) separator_ = candidate;
    std::vector<Cell> cells;
    quotes = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= content.size(); ++i) {
      if (i < content.size() && content[i] == '"') quotes = !quotes;
      if (i < content.size() && (quotes || content[i] != separator_)) continue;
      cells.push_back(trimmed({content.substr(begin, i - begin), begin}));
      begin = i + 1;
    }
    while (cells.size() > 1 && cells.back().text.empty()) cells.pop_back();
    return cells;
  }

  void header(const std::vector<Cell>& cells) {
    std::optional<FrameColumn> best;
    for (const Kind wanted : {Kind::step, Kind::stamp, Kind::rate}) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto column = frame_column(cells[i].text);
        if (!column || column->kind != wanted) continue;
        if (best)
          complain(cells[i].begin, "the columns " + in_quotes(list_.column) + " and " +
                                       in_quotes(cells[i].text) +
                                       " say the same thing; leave one of them out");
        best = column;
        place_ = i;
        list_.column = std::string(cells[i].text);
      }
      if (best) break;
    }
    if (!best)
      complain(
          cells.front().begin,
          "the header " + (cells.size() == 1 ? in_quotes(cells.front().text) + " names" : "names") +
              " neither steps (dt, frame time), nor time stamps (time, timestamp), nor rates (fps), with "
              "a unit s, ms, us or ns if any");
    list_.kind = best->kind;
    list_.unit_is_given = best->unit.has_value() || best->kind == Kind::rate;
    unit_ = best->unit.value_or(*frame_unit(best->kind == Kind::rate ? "hz" : "s"));
    list_.unit = best->kind == Kind::rate ? "Hz" : std::string(unit_.name);
  }

  void take(const Cell& cell) {
    const Rational value = seconds(cell);
    if (list_.steps.size() >= kMostFrames)
      complain(cell.begin, "there are more than 1,000,000 frames, which is our limit");
    if (list_.kind != Kind::stamp) {
      list_.steps.push_back(value);
      return;
    }
    if (last_ && value <= *last_)
      complain(cell.begin, "the time stamp " + in_quotes(cell.text) +
                               " does not advance: the one before it, " + in_quotes(last_text_) +
                               " in line " + std::to_string(last_line_) + ", is " +
                               (value == *last_ ? "the same" : "later"));
    if (last_) list_.steps.push_back(value - *last_);
    last_ = value;
    last_text_ = std::string(cell.text);
    last_line_ = number_;
  }

  /// The value of a cell: a time stamp, or the length of a step, which is checked to be positive.
  Rational seconds(const Cell& cell) {
    const std::string_view text = cell.text;
    const std::string what = list_.kind == Kind::stamp ? "time stamp" : "step";
    if (text.empty()) complain(cell.begin, "the " + what + " is missing");
    const std::size_t end = text.find_last_of("0123456789.");
    if (!number_like(text) || end == std::string_view::npos)
      complain(cell.begin, in_quotes(text) + " is not a number");
    Rational value;
    try {
      value = Rational::parse(text.substr(0, end + 1));
    } catch (const BadInput& e) {
      complain(cell.begin, e.what());
    }
    FrameUnit unit = unit_;
    if (std::string_view suffix = text.substr(end + 1); !suffix.empty()) {
      suffix.remove_prefix(std::min(suffix.find_first_not_of(kBlanks), suffix.size()));
      const auto named = frame_unit(suffix);
      if (!named)
        complain(cell.begin + end + 1,
                 "unknown unit " + in_quotes(suffix) + "; the units are s, ms, us, ns, Hz and fps");
      if (list_.kind == Kind::stamp && named->rate) complain(cell.begin, "a time stamp is no rate");
      unit = *named;
      list_.unit_is_given = true;
    }
    if (value.digits() > kMostDigits)
      complain(cell.begin, "the number has more than 100 digits, which is our limit");
    if (list_.kind != Kind::stamp && value.sign() <= 0)
      complain(cell.begin, "the " + std::string(unit.rate ? "rate " : "step ") + in_quotes(text) + " is " +
                               (value.is_zero() ? "0" : "negative") + "; a frame takes longer than 0 s");
    return unit.rate ? Rational(1) / value : value * unit.seconds;
  }

  std::string_view text_;
  FrameList list_;
  std::string_view line_;
  int number_ = 0;
  bool begun_ = false;  ///< whether a line with something in it has been seen
  char separator_ = '\n';
  std::size_t place_ = 0;  ///< which cell of a row is read
  FrameUnit unit_ = *frame_unit("s");
  std::optional<Rational> last_;  ///< the time stamp before
  std::string last_text_;
  int last_line_ = 0;
};

}  // namespace

Rational FrameList::duration() const {
  Rational sum;
  for (const Rational& h : steps) sum += h;
  return sum;
}

bool FrameList::equal() const {
  return std::ranges::all_of(steps, [&](const Rational& h) { return h == steps.front(); });
}

FrameList parse_frames(std::string_view text, const std::string& file) { return Reader(text, file).frames(); }

FrameList read_frames(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  constexpr std::size_t kPiece = 1'000'000;
  while (in && text.size() <= kLargestFile) {
    const std::size_t size = text.size();
    text.resize(size + kPiece);
    in.read(text.data() + size, kPiece);
    text.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof() && text.size() <= kLargestFile) throw UnreadableFile("cannot read the file '" + path + "'");
  if (text.size() > kLargestFile) throw SyntaxError(path, 1, 1, "the file is larger than 64 MB, our limit");
  return parse_frames(text, path);
}

}  // namespace shortfall
