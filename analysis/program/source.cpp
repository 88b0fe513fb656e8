// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/source.hpp"
#include "analysis/program/utf8.hpp"

#include <algorithm>

namespace shortfall {

namespace {

constexpr std::size_t kLongestFile = 1'000'000;
constexpr std::size_t kLongestShownLine = 400;  // a longer line and its caret would only fill the screen

/// Tabs are blanks; other control characters would reach a terminal through messages.
bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == '\x7F'; }

int characters(std::string_view text) {
  return static_cast<int>(std::ranges::count_if(text, [](char c) { return !continues_utf8(c); }));
}

/// 10,000 for 10000.
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, 1, ',');
  return text;
}

std::string in_hexadecimal(char c) {
  static constexpr std::string_view kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("0x") + kDigits[byte / 16] + kDigits[byte % 16];
}

}  // namespace

Source::Source(std::string file, std::string_view text, std::size_t longest_line) : file_(std::move(file)) {
  if (text.size() > kLongestFile)
    throw SyntaxError(file_, 1, 1, "the file is larger than 1 MB; an integrator needs about twelve lines");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) end = text.size();
    std::string_view line = text.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    const int number = line_count() + 1;
    if (line.size() > longest_line)
      throw SyntaxError(file_, number, 1, "the line is longer than " + grouped(longest_line) + " bytes");
    std::size_t plain = line.size();
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t length = is_control(line[i]) ? 0 : utf8_length(line, i);
      if (length == 0)
        throw SyntaxError(file_, number, characters(line.substr(0, i)) + 1,
                          "this is not a text file (UTF-8): it has the byte " + in_hexadecimal(line[i]));
      if (length > 1) plain = std::min(plain, i);
      i += length;
    }
    lines_.emplace_back(line);
    plain_.push_back(plain);
    begin = end + 1;
  }
  if (lines_.empty()) {
    lines_.emplace_back();
    plain_.push_back(0);
  }
}

Place Source::place(int line, std::size_t byte) const {
  if (byte <= plain_[line - 1]) return {line, static_cast<int>(byte) + 1};
  return {line, characters(std::string_view(lines_[line - 1]).substr(0, byte)) + 1};
}

SyntaxError Source::error(Place place, const std::string& what) const {
  const bool shown =
      place.line >= 1 && place.line <= line_count() && line(place.line).size() <= kLongestShownLine;
  return SyntaxError(file_, place.line, place.column, what, shown ? line(place.line) : std::string());
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kShown = 40;
  return std::string(text.substr(0, kShown)) + (text.size() > kShown ? "..." : "");
}

}  // namespace shortfall
