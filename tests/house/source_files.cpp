// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/house/source_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>

namespace shortfall::house {
namespace {

namespace fs = std::filesystem;

/// Where the literal or comment that starts at `begin` ends (one past), or `begin` when none starts there.
std::size_t end_of_literal(std::string_view text, std::size_t begin) {
  const std::string_view rest = text.substr(begin);
  const auto past = [&](std::size_t found, std::size_t length) {
    return found == std::string_view::npos ? text.size() : found + length;
  };
  if (rest.starts_with("//")) return past(text.find('\n', begin), 0);
  if (rest.starts_with("/*")) return past(text.find("*/", begin + 2), 2);
  if (rest.starts_with("R\"")) {
    const std::size_t open = text.find('(', begin);
    if (open == std::string_view::npos) return text.size();
    const std::string close = ")" + std::string(text.substr(begin + 2, open - begin - 2)) + "\"";
    return past(text.find(close, open), close.size());
  }
  const char quote = text[begin];
  if (quote != '"' && quote != '\'') return begin;
  // 1'000 is a number.
  if (quote == '\'' && begin > 0 && std::isalnum(static_cast<unsigned char>(text[begin - 1]))) return begin;
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != quote && text[at] != '\n') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

bool is_include(std::string_view text, std::size_t at) {
  return (at == 0 || text[at - 1] == '\n') && text.substr(at).starts_with("#include");
}

/// The files with one of these endings, sorted by path; what a build wrote is not the project's.
std::vector<SourceFile> files_that_end(std::initializer_list<std::string_view> endings) {
  const fs::path root = SHORTFALL_SOURCE_DIR;
  std::vector<SourceFile> files;
  for (const char* folder : {"analysis", "notebooks-export", "cli", "tests", "bench", "examples", "fuzz",
                             "lessons", "python", "cmake"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string name = entry.path().filename().string();
      if (!entry.is_regular_file() ||
          std::ranges::none_of(endings, [&](auto e) { return name.ends_with(e); }))
        continue;
      std::ifstream in(entry.path(), std::ios::binary);
      files.push_back({fs::relative(entry.path(), root).generic_string(),
                       std::string(std::istreambuf_iterator<char>(in), {})});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

}  // namespace

std::vector<SourceFile> source_files() { return files_that_end({".cpp", ".hpp"}); }

std::vector<SourceFile> scripts() { return files_that_end({".py", ".sh", ".cmake", "CMakeLists.txt"}); }

std::vector<std::string_view> lines(std::string_view text) {
  std::vector<std::string_view> result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string code(std::string_view text) {
  std::string result(text);
  for (std::size_t at = 0; at < text.size();) {
    if (is_include(text, at)) {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    const std::size_t end = end_of_literal(text, at);
    for (std::size_t i = at; i < end; ++i) {
      if (result[i] != '\n') result[i] = ' ';
    }
    at = std::max(end, at + 1);
  }
  return result;
}

}  // namespace shortfall::house
