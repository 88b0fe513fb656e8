// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/outcome_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/general_text.hpp"

namespace shortfall {

std::string bits_text(double value) {
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(value), std::chars_format::hex).ptr;
  const std::string digits(text.data(), end);
  return (std::signbit(value) ? "-" : "") + (std::isfinite(value) ? "0x" + digits : digits);
}

std::string bits_text(const std::vector<double>& values) {
  std::string text;
  for (double v : values) text += (text.empty() ? "" : " ") + bits_text(v);
  return text;
}

double bits_of(const std::string& text) { return double_of(text); }

std::vector<double> all_bits_of(const std::string& text) {
  std::vector<double> values;
  std::istringstream words(text);
  for (std::string word; words >> word;) values.push_back(bits_of(word));
  return values;
}

std::string as_line(const SceneOutcome& o) {
  std::string why = o.why;
  std::ranges::replace(why, '\n', ' ');
  std::ranges::replace(why, '\t', ' ');
  return std::to_string(o.steps) + "\t" + std::to_string(o.evaluations) + "\t" + (o.failed ? "1" : "0") +
         "\t" + why + "\t" + bits_text(o.errors) + "\t" + bits_text(o.nanoseconds) + "\n";
}

SceneOutcome outcome_of_line(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  if (fields.size() != 6) throw Error("an outcome of another machine cannot be read: '" + line + "'");
  SceneOutcome o;
  o.steps = std::atoll(fields[0].c_str());
  o.evaluations = std::atoll(fields[1].c_str());
  o.failed = fields[2] == "1";
  o.why = fields[3];
  o.errors = all_bits_of(fields[4]);
  o.nanoseconds = bits_of(fields[5]);
  return o;
}

}  // namespace shortfall
