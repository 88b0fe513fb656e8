// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/log.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/log_cells.hpp"
#include "analysis/identify/log_columns.hpp"
#include "analysis/identify/log_rounding.hpp"

namespace shortfall {

namespace {

using Thing = LogColumns::Thing;

constexpr std::size_t kLongestLine = 100'000;
constexpr std::size_t kSamples = 20;  // rows without a header are understood after so many
constexpr std::size_t kMostBodies = 1000;
constexpr double kLargestWhole = 999'999'999'999'999;  // every whole number up to it is a double and an int64

class Reader {
 public:
  Reader(std::istream& in, std::string name, const LogOptions& options) : in_(in), options_(options) {
    log_.file = std::move(name);
  }

  Log log() {
    while (!full_ && next_line()) take_line();
    if (!columns_known_ && !waiting_.empty()) begin_without_header();
    finish();
    return std::move(log_);
  }

 private:
  struct Waiting {
    int line;
    std::vector<std::string> cells;
  };

  [[noreturn]] void complain(const std::string& what, int line = 0, std::size_t cell = 0) const {
    throw SyntaxError(log_.file, std::max(line > 0 ? line : line_, 1), static_cast<int>(cell) + 1, what);
  }

  bool next_line() {
    text_.clear();
    ++line_;
    for (int c; (c = in_.get()) != std::char_traits<char>::eof();) {
      if (c == '\n') return true;
      if ((c < 0x20 && c != '\t' && c != '\r') || c == 0x7F)
        complain("this is no text (a binary file, or UTF-16?)");
      text_ += static_cast<char>(c);
      if (text_.size() > kLongestLine) complain("the line is longer than 100,000 bytes");
    }
    return !text_.empty();
  }

  void take_line() {
    if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
    const std::size_t first = text_.find_first_not_of(" \t\r");
    if (first == std::string::npos || text_[first] == '#') return;
    if (text_[first] == '{') {
      take_json();
      return;
    }
    if (!begun_) separator_ = separator_of(text_);
    std::vector<std::string> cells = split_cells(text_, separator_);
    if (!begun_) {
      begun_ = true;
      if (std::ranges::none_of(cells, looks_like_number)) {
        header_ = cells;
        choose([&] { return columns_of_header(header_, options_.columns); });
        return;
      }
      if (!options_.columns.empty()) complain("--columns names columns, and the file has no header");
    }
    if (columns_known_)
      take(cells, line_);
    else if (waiting_.push_back({line_, std::move(cells)}); waiting_.size() == kSamples)
      begin_without_header();
  }

  void take_json() {
    std::vector<JsonCell> found;
    try {
      found = json_cells(text_);
    } catch (const BadInput& e) {
      complain(e.what());
    }
    if (!columns_known_) {
      begun_ = true;
      for (const JsonCell& c : found) header_.push_back(c.name);
      choose([&] { return columns_of_header(header_, options_.columns); });
    }
    std::vector<std::string> cells(header_.size());
    for (std::size_t i = 0; i < header_.size(); ++i) {
      const auto same = std::ranges::find(found, header_[i], &JsonCell::name);
      if (same != found.end()) cells[i] = same->value;
    }
    take(cells, line_);
  }

  void choose(const std::function<LogColumns()>& columns) {
    try {
      columns_ = columns();
    } catch (const BadInput& e) {
      complain(e.what());
    }
    columns_known_ = true;
    log_.velocities = columns_.velocities();
    log_.unit = columns_.unit;
    log_.units_in_metre = Rational(1) / columns_.metres;
    for (int axis = 0; axis < 3; ++axis) {
      const int place = columns_.place[static_cast<std::size_t>(Thing::x + axis)];
      if (place < 0) continue;
      log_.axes.push_back(axis);
      if (!header_.empty())
        log_.names[static_cast<std::size_t>(axis)] = header_[static_cast<std::size_t>(place)];
    }
  }

  void begin_without_header() {
    const std::vector<Waiting> rows = std::move(waiting_);
    waiting_.clear();
    choose([&] {
      std::vector<std::vector<std::string>> cells;
      for (const Waiting& w : rows)
        if (w.cells.size() == rows.front().cells.size()) cells.push_back(w.cells);
      return columns_without_header(cells);
    });
    for (const Waiting& w : rows)
      if (!full_) take(w.cells, w.line);
  }

  std::string title(std::size_t place) const {
    return place < header_.size() ? "column '" + header_[place] + "'" : "column " + std::to_string(place + 1);
  }

  double number(const std::vector<std::string>& cells, std::size_t place, int line) const {
    if (place >= cells.size() || cells[place].empty())
      complain("the row has no value in " + title(place), line, place);
    const std::string& text = cells[place];
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* const end = text.data() + text.size();
    double value = 0;
    const auto [stopped, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stopped != end || !std::isfinite(value))
      complain("'" + text.substr(0, 60) + "' in " + title(place) + " is no number that a body can have", line,
               place);
    return value;
  }

  std::optional<double> value(const std::vector<std::string>& cells, Thing thing, int line) {
    if (!columns_.has(thing)) return std::nullopt;
    return number(cells, static_cast<std::size_t>(columns_.place[thing]), line);
  }

  void take(const std::vector<std::string>& cells, int line) {
    if (!this_body(cells)) return;
    Log::Row row;
    row.line = line;
    const auto stamp = value(cells, Thing::time, line);
    const auto counted = value(cells, Thing::frame, line);
    if (another_of_the_same_stamp(stamp ? stamp : counted, line)) return;
    if (counted) check_frame(*counted, line);
    if (stamp) row.time = *stamp * columns_.seconds.to_double();
    row.frame = counted ? std::lround(*counted - first_frame_) : static_cast<long>(log_.rows.size());
    for (const int axis : log_.axes) {
      const auto a = static_cast<std::size_t>(axis);
      row.x[a] = watched(cells, static_cast<Thing>(Thing::x + axis), positions_, line);
      if (log_.velocities) row.v[a] = watched(cells, static_cast<Thing>(Thing::vx + axis), speeds_, line);
    }
    log_.rows.push_back(row);
    full_ = log_.rows.size() == kMostRows;
    log_.more = full_ && in_.peek() != std::char_traits<char>::eof();
  }

  void check_frame(double frame, int line) {
    const auto place = static_cast<std::size_t>(columns_.place[Thing::frame]);
    if (frame != std::floor(frame)) complain("the frame number is not whole", line, place);
    if (std::fabs(frame) > kLargestWhole) complain("a frame number has 15 digits or fewer", line, place);
    if (log_.rows.empty())
      first_frame_ = frame;
    else if (frame <= last_frame_)
      complain("the frame number does not grow here: the row before has " + cell_text(last_frame_), line,
               place);
    last_frame_ = frame;
  }

  static std::string cell_text(double whole) { return std::to_string(static_cast<long long>(whole)); }

  double watched(const std::vector<std::string>& cells, Thing thing, RoundingWatch& watch, int line) {
    const auto place = static_cast<std::size_t>(columns_.place[thing]);
    const double result = number(cells, place, line);
    watch.see(cells[place], result);
    return result;
  }

  /// Whether the row belongs to the body that is read.
  bool this_body(const std::vector<std::string>& cells) {
    if (!columns_.has(Thing::body)) return true;
    const auto place = static_cast<std::size_t>(columns_.place[Thing::body]);
    const std::string name = place < cells.size() ? cells[place] : "";
    if (std::ranges::find(log_.bodies, name) == log_.bodies.end() && log_.bodies.size() < kMostBodies)
      log_.bodies.push_back(name);
    return name == (options_.body.empty() ? log_.bodies.front() : options_.body);
  }

  /// Rows that share a stamp are bodies that take turns: the one asked for, by its number, is read.
  bool another_of_the_same_stamp(std::optional<double> stamp, int line) {
    if (!stamp) return false;
    const auto place =
        static_cast<std::size_t>(columns_.place[columns_.has(Thing::time) ? Thing::time : Thing::frame]);
    if (last_stamp_ && *stamp < *last_stamp_)
      complain("the time goes back here: the row before has a later " + title(place), line, place);
    turn_ = last_stamp_ && *stamp == *last_stamp_ ? turn_ + 1 : 0;
    last_stamp_ = stamp;
    if (columns_.has(Thing::body)) {
      if (turn_ > 0) complain("the body has two rows with the same " + title(place), line, place);
      return false;
    }
    turns_ = std::max(turns_, turn_ + 1);
    const std::string wanted = options_.body.empty() ? "1" : options_.body;
    return wanted != std::to_string(turn_ + 1);
  }

  void finish() {
    if (!begun_) complain("the file is empty");
    for (int k = 1; turns_ > 1 && k <= turns_; ++k) log_.bodies.push_back(std::to_string(k));
    if (!options_.body.empty() && std::ranges::find(log_.bodies, options_.body) == log_.bodies.end())
      complain(log_.bodies.empty() ? "--body: the log has one body only"
                                   : "there is no body '" + options_.body.substr(0, 60) + "'");
    if (log_.bodies.size() == 1) log_.bodies.clear();
    if (!options_.body.empty()) {
      const auto chosen = std::ranges::find(log_.bodies, options_.body);
      if (chosen != log_.bodies.end()) std::rotate(log_.bodies.begin(), chosen, chosen + 1);
    }
    constexpr std::size_t kFewest = 4;
    if (log_.rows.size() < kFewest)
      complain("there " +
               std::string(log_.rows.size() == 1 ? "is one row"
                                                 : "are " + std::to_string(log_.rows.size()) + " rows") +
               "; what made a motion can be told from " + std::to_string(kFewest) + " rows or more");
    log_.position_rounding = positions_.rounding();
    log_.velocity_rounding = log_.velocities ? speeds_.rounding() : log_.position_rounding;
    // Zeros and round numbers in one column do not make the other one's numbers rounded.
    if (log_.velocities && log_.position_rounding.exact() != log_.velocity_rounding.exact()) agree();
    // Nine digits of a binary32 stand for it, and are not it.
    const bool narrow_x = log_.position_rounding.kind == LogRounding::Kind::binary32;
    const bool narrow_v = log_.velocity_rounding.kind == LogRounding::Kind::binary32;
    for (Log::Row& row : log_.rows)
      for (std::size_t i = 0; i < 3; ++i) {
        if (narrow_x) row.x[i] = static_cast<float>(row.x[i]);
        if (narrow_v) row.v[i] = static_cast<float>(row.v[i]);
      }
    if (columns_.has(Thing::time)) read_steps();
  }

  void agree() {
    LogRounding& x = log_.position_rounding;
    LogRounding& v = log_.velocity_rounding;
    LogRounding& rounded = x.exact() ? v : x;
    const LogRounding& exact = x.exact() ? x : v;
    if (rounded.digits <= 3) rounded = exact;
  }

  void read_steps() {
    log_.shortest_step = std::numeric_limits<double>::infinity();
    log_.longest_step = -log_.shortest_step;
    const double whole = log_.rows.back().time - log_.rows.front().time;
    const bool counted = columns_.has(Thing::frame);
    const double mean = whole / static_cast<double>(counted ? log_.rows.back().frame
                                                            : static_cast<long>(log_.rows.size()) - 1);
    for (std::size_t i = 1; i < log_.rows.size(); ++i) {
      double step = log_.rows[i].time - log_.rows[i - 1].time;
      if (counted) step /= static_cast<double>(log_.rows[i].frame - log_.rows[i - 1].frame);
      log_.shortest_step = std::min(log_.shortest_step, step);
      log_.longest_step = std::max(log_.longest_step, step);
    }
    // Stamps are often milliseconds: they say the mean well and each step badly.
    const double coarse = std::max(0.0011, 0.02 * mean);
    log_.equal_steps = log_.longest_step - log_.shortest_step <= std::min(2 * coarse, 0.15 * mean);
    if (log_.equal_steps) log_.dt = nice_step(mean, log_.rows.size());
  }

  /// A rate in whole hertz or a decimal, where the stamps leave it open.
  static Rational nice_step(double mean, std::size_t rows) {
    const double slack = 0.0011 / static_cast<double>(rows);
    const double rate = std::round(1 / mean);
    if (rate >= 1 && rate <= kLargestWhole && std::fabs(1 / rate - mean) <= std::max(slack, 1e-9 * mean))
      return Rational(1, static_cast<std::int64_t>(rate));
    for (int digits = 1; digits < 9; ++digits) {
      const double scale = std::pow(10.0, digits);
      if (const double units = std::round(mean * scale); units < 1 || units > kLargestWhole) continue;
      if (std::fabs(std::round(mean * scale) / scale - mean) <= std::max(1e-9 * mean, 1e-15))
        return Rational(std::llround(mean * scale), static_cast<std::int64_t>(scale));
    }
    return Rational::from_double(mean);
  }

  std::istream& in_;
  const LogOptions& options_;
  Log log_;
  std::string text_;
  int line_ = 0;
  bool begun_ = false, columns_known_ = false, full_ = false;
  char separator_ = ',';
  std::vector<std::string> header_;
  std::vector<Waiting> waiting_;
  LogColumns columns_;
  RoundingWatch positions_, speeds_;
  std::optional<double> last_stamp_;
  int turn_ = 0, turns_ = 1;
  double first_frame_ = 0, last_frame_ = 0;
};

}  // namespace

Log read_log(const std::string& path, const LogOptions& options) {
  std::ifstream in(path, std::ios::binary);
  if (!in || in.peek() == std::char_traits<char>::eof()) {
    // A folder opens and cannot be read; an empty file can.
    if (!in.is_open() || in.bad()) throw UnreadableFile("cannot read the file '" + path + "'");
  }
  return Reader(in, path, options).log();
}

Log parse_log(const std::string& text, const std::string& name, const LogOptions& options) {
  std::istringstream in(text);
  return Reader(in, name, options).log();
}

}  // namespace shortfall
