// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/identify/log_cells.hpp"

#include <algorithm>
#include <cctype>

#include "analysis/algebra/error.hpp"
#include "analysis/program/json_text.hpp"

namespace shortfall {

namespace {

void collect(const JsonValue& value, const std::string& name, std::vector<JsonCell>& cells) {
  using Kind = JsonValue::Kind;
  const auto inner = [&](const std::string& key) { return name.empty() ? key : name + "." + key; };
  if (value.kind == Kind::object) {
    for (const auto& [key, member] : value.members) collect(member, inner(key.text), cells);
  } else if (value.kind == Kind::array) {
    for (std::size_t i = 0; i < value.items.size(); ++i)
      collect(value.items[i], inner(std::to_string(i)), cells);
  } else if (value.kind == Kind::number || value.kind == Kind::string) {
    cells.push_back({name, value.text});
  }
}

}  // namespace

std::vector<JsonCell> json_cells(const std::string& line) {
  std::vector<JsonCell> cells;
  try {
    collect(json_value(Source("line", line)), "", cells);
  } catch (const SyntaxError& e) {
    throw BadInput("this is no object of JSON lines (" + std::string(e.what()) + ")");
  }
  return cells;
}

std::vector<std::string> split_cells(std::string_view line, char separator) {
  std::vector<std::string> cells;
  const auto put = [&](std::string_view cell) {
    const std::size_t first = cell.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
      cells.emplace_back();
      return;
    }
    cell = cell.substr(first, cell.find_last_not_of(" \t\r") - first + 1);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    cells.emplace_back(cell);
  };
  if (separator == ' ') {
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t begin = line.find_first_not_of(" \t\r", i);
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
      put(line.substr(begin, end - begin));
      i = end;
    }
    return cells;
  }
  bool quotes = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quotes = !quotes;
    if (i < line.size() && (quotes || line[i] != separator)) continue;
    put(line.substr(begin, i - begin));
    begin = i + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
  return cells;
}

char separator_of(std::string_view line) {
  for (const char candidate : {'\t', ';', ','})
    if (line.find(candidate) != std::string_view::npos) return candidate;
  return ' ';
}

bool looks_like_number(std::string_view text) {
  if (text.empty()) return false;
  std::string word;
  for (char c : text.substr(0, 12)) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word == "nan" || word == "-nan" || word == "inf" || word == "-inf" || word == "infinity") return true;
  const char c = text.front();
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

}  // namespace shortfall
