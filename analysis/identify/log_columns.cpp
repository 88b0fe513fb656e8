// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/log_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"
#include "analysis/algebra/unit.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

using Thing = LogColumns::Thing;

constexpr std::array<const char*, LogColumns::things> kNames = {"frame", "time", "body", "x", "y",
                                                                "z",     "vx",   "vy",   "vz"};

/// A header without its unit, in small letters and digits only; and the unit.
struct Header {
  std::string key;
  std::string unit;
};

std::string small(const std::string& text) {
  std::string result;
  for (const char c : text) result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

Header header_of(const std::string& text) {
  Header result;
  std::string name = small(text);
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t from = name.find(open), to = name.find(close);
    if (from == std::string::npos || to == std::string::npos || to < from) continue;
    const std::string inside = name.substr(from + 1, to - from - 1);
    const bool index =
        !inside.empty() && std::ranges::all_of(inside, [](char c) { return c >= '0' && c <= '9'; });
    if (index) continue;
    result.unit = inside;
    name.erase(from, to - from + 1);
    break;
  }
  if (result.unit.empty())
    for (const char* unit : {"_mm", "_cm", "_px", "_ms", "_us", "_m", "_s"})
      if (name.size() > std::string(unit).size() && name.ends_with(unit)) {
        result.unit = unit + 1;
        name.erase(name.size() - result.unit.size() - 1);
        break;
      }
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) result.key += c;
  return result;
}

bool one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::ranges::any_of(words, [&](const char* w) { return word == w; });
}

bool ends_in(const std::string& word, std::initializer_list<const char*> words) {
  return std::ranges::any_of(words, [&](const char* w) { return word.ends_with(w); });
}

/// What a name means; nothing for other columns, which are not read.
std::optional<Thing> meaning(const std::string& key) {
  if (one_of(key,
             {"frame", "frames", "step", "tick", "n", "i", "index", "framenumber", "frameno", "frameid"}))
    return LogColumns::frame;
  if (one_of(key, {"time", "t", "timestamp", "seconds", "sec", "simtime", "elapsed", "stamp"}))
    return LogColumns::time;
  if (one_of(key, {"body", "id", "name", "object", "entity", "bodyid", "objectid", "actor"}))
    return LogColumns::body;
  if (one_of(key, {"height", "altitude", "position", "pos", "h"})) return LogColumns::y;
  if (one_of(key, {"velocity", "vel", "v", "verticalvelocity", "verticalspeed"})) return LogColumns::vy;
  if (key.empty()) return std::nullopt;
  const char last = key.back();
  int axis = last >= 'x' && last <= 'z' ? last - 'x' : last >= '0' && last <= '2' ? last - '0' : -1;
  if (axis < 0) return std::nullopt;
  const std::string stem = key.substr(0, key.size() - 1);
  const bool letter = last >= 'x';
  if ((letter && one_of(stem, {"", "p", "r", "q"})) ||
      ends_in(stem, {"pos", "position", "translation", "location", "loc", "center", "centre", "com"}))
    return static_cast<Thing>(LogColumns::x + axis);
  if ((letter && one_of(stem, {"v", "d"})) || ends_in(stem, {"vel", "velocity", "linvel", "speed", "velo"}))
    return static_cast<Thing>(LogColumns::vx + axis);
  return std::nullopt;
}

void set_length(LogColumns& columns, const std::string& unit) {
  const std::string length = unit.substr(0, unit.find('/'));
  const PhysicalUnit* known = find_unit(length);
  if (!known || known->dimension != kPhysicalLength) return;
  columns.unit = length;
  columns.metres = known->scale;
}

void set_time(LogColumns& columns, const std::string& unit) {
  const PhysicalUnit* known = find_unit(unit == "µs" ? "us" : unit);
  if (known && known->dimension == kPhysicalTime) columns.seconds = known->scale;
}

/// Whether a column of text counts: each number larger than the one before by the same amount.
std::optional<double> even_growth(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  std::vector<double> values;
  for (const auto& row : rows)
    if (column < row.size()) values.push_back(double_of(row[column]));
  if (values.size() < 3) return std::nullopt;
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  if (!(step > 0)) return std::nullopt;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (std::fabs(values[i] - values[i - 1] - step) > 0.1 * step) return std::nullopt;
  return step;
}

}  // namespace

bool LogColumns::velocities() const {
  for (int axis = 0; axis < 3; ++axis)
    if (place[x + axis] >= 0 && place[vx + axis] < 0) return false;
  return positions();
}

LogColumns columns_of_header(const std::vector<std::string>& header,
                             const std::map<std::string, std::string>& asked) {
  LogColumns columns;
  std::vector<bool> taken(header.size(), false);
  for (const auto& [thing, name] : asked) {
    const auto known = std::ranges::find(kNames, thing);
    if (known == kNames.end())
      throw BadInput("no column is called '" + thing + "': there are frame, time, body, x, y, z, vx, vy, vz");
    auto found = std::ranges::find(header, name);
    if (found == header.end()) found = std::ranges::find(header, small(name), small);
    if (found == header.end())
      throw BadInput("there is no column '" + name + "'" + did_you_mean(name, header));
    const std::size_t at = static_cast<std::size_t>(found - header.begin());
    columns.place[static_cast<std::size_t>(known - kNames.begin())] = static_cast<int>(at);
    taken[at] = true;
  }
  for (std::size_t i = 0; i < header.size(); ++i) {
    const Header h = header_of(header[i]);
    const std::optional<Thing> thing = taken[i] ? std::nullopt : meaning(h.key);
    if (thing && columns.place[*thing] < 0)
      columns.place[*thing] = static_cast<int>(i);
    else if (thing && !asked.contains(kNames[*thing]))
      throw BadInput("the columns '" + header[static_cast<std::size_t>(columns.place[*thing])] + "' and '" +
                     header[i] + "' are both " + kNames[*thing] + "; say which one: --columns " +
                     kNames[*thing] + "=" + header[i]);
  }
  // A "v" beside a single position is its velocity, whatever that is called.
  if (const int vy = columns.place[LogColumns::vy];
      vy >= 0 && columns.place[LogColumns::y] < 0 && !asked.contains("vy") &&
      one_of(header_of(header[static_cast<std::size_t>(vy)]).key, {"velocity", "vel", "v"})) {
    const bool x = columns.place[LogColumns::x] >= 0, z = columns.place[LogColumns::z] >= 0;
    const int own = x ? LogColumns::vx : LogColumns::vz;
    if (x != z && columns.place[own] < 0) std::swap(columns.place[own], columns.place[LogColumns::vy]);
  }
  for (int t = 0; t < LogColumns::things; ++t) {
    if (columns.place[t] < 0) continue;
    const std::string unit = header_of(header[static_cast<std::size_t>(columns.place[t])]).unit;
    if (t == LogColumns::time)
      set_time(columns, unit);
    else if (t >= LogColumns::x && t <= LogColumns::z)
      set_length(columns, unit);
  }
  if (!columns.positions()) {
    std::string names;
    for (const std::string& h : header) names += (names.empty() ? "'" : ", '") + h.substr(0, 40) + "'";
    throw BadInput("no column is a position among " + names.substr(0, 300) +
                   "; say which one: --columns y=NAME");
  }
  return columns;
}

LogColumns columns_without_header(const std::vector<std::vector<std::string>>& rows) {
  LogColumns columns;
  const std::size_t count = rows.empty() ? 0 : rows.front().size();
  std::size_t next = 0;
  const auto counts = [&](std::size_t column) {
    const auto step = even_growth(rows, column);
    return step && *step == 1 && rows[0][column].find('.') == std::string::npos;
  };
  if (count > 1 && counts(0)) columns.place[LogColumns::frame] = static_cast<int>(next++);
  // Six columns are three positions and three velocities, though a position may grow evenly too.
  const std::size_t rest = count - next;
  if (rest > 1 && rest != 6 && even_growth(rows, next))
    columns.place[LogColumns::time] = static_cast<int>(next++);
  const std::size_t left = count - next;
  const auto put = [&](Thing from, std::size_t axes, bool vertical) {
    for (std::size_t k = 0; k < axes; ++k)
      columns.place[static_cast<std::size_t>(from) + k + (vertical ? 1 : 0)] = static_cast<int>(next++);
  };
  switch (left) {
    case 1:
      put(LogColumns::x, 1, true);
      break;
    case 2:
      put(LogColumns::x, 2, false);
      break;
    case 3:
      put(LogColumns::x, 3, false);
      break;
    case 4:
      put(LogColumns::x, 2, false);
      put(LogColumns::vx, 2, false);
      break;
    case 6:
      put(LogColumns::x, 3, false);
      put(LogColumns::vx, 3, false);
      break;
    default:
      throw BadInput("there are " + std::to_string(count) +
                     " columns and no header that says what they are; write a line such as "
                     "'time,x,y,z,vx,vy,vz' above them");
  }
  return columns;
}

}  // namespace shortfall
