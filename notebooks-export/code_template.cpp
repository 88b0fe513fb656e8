// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/code_template.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

const std::vector<std::string>& value_of(std::string_view name,
                                         const std::map<std::string, std::vector<std::string>>& values) {
  const auto found = values.find(std::string(name));
  if (found == values.end())
    throw Error("a template asks for '" + std::string(name) + "', which has no value");
  return found->second;
}

}  // namespace

std::string_view code_template(std::string_view name, Language language) {
  const std::string path = std::string(name) + file_ending(language) + ".in";
  const std::string_view text = embedded_text(code_templates(), path);
  if (text.empty()) throw Error("there is no template " + path);
  return text;
}

std::string filled(std::string_view text, const std::map<std::string, std::vector<std::string>>& values) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t first = line.find('@');
    if (first == std::string_view::npos) {
      result += line;
      continue;
    }
    const std::size_t blank = line.find_first_not_of(" \t/#");
    const std::size_t close = line.find('@', first + 1);
    if (first == blank && close + 2 == line.size()) {
      for (const std::string& part : value_of(line.substr(first + 1, close - first - 1), values))
        result += (part.empty() ? "" : std::string(line.substr(0, first)) + part) + "\n";
      continue;
    }
    while (!line.empty()) {
      const std::size_t open = line.find('@');
      result += line.substr(0, open);
      if (open == std::string_view::npos) break;
      const std::size_t after = line.find('@', open + 1);
      for (const std::string& part : value_of(line.substr(open + 1, after - open - 1), values))
        result += part;
      line.remove_prefix(after + 1);
    }
  }
  return result;
}

}  // namespace shortfall
