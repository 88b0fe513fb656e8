// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/house/source_files.hpp"

namespace shortfall::house {
namespace {

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::string_view word(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() && in_word(text[n])) ++n;
  return text.substr(0, n);
}

/// The type that a line defines at the left edge; empty when it defines none, or specialises a template.
std::string_view defined_type(std::string_view line) {
  for (const std::string_view kind : {"struct ", "class ", "union ", "enum class ", "enum "}) {
    if (!line.starts_with(kind)) continue;
    const std::string_view name = word(line.substr(kind.size()));
    const std::string_view rest = line.substr(kind.size() + name.size());
    if (name == "class" || rest.starts_with('<') || rest.starts_with("::")) return {};
    if (rest.find('{') == std::string_view::npos || rest.find(';') < rest.find('{')) return {};
    return name;
  }
  return {};
}

/// "name(const Rational&, int)" of a function that is defined at the left edge from line i on; empty where
/// none is, and for templates and members.
std::string defined_function(const std::vector<std::string_view>& compiled, std::size_t i) {
  const std::string_view line = compiled[i];
  if (line.empty() || !(std::isalpha(static_cast<unsigned char>(line[0])) || line[0] == '[')) return {};
  if (i > 0 && compiled[i - 1].starts_with("template")) return {};
  for (const std::string_view other :
       {"namespace", "struct", "class", "union", "enum", "template", "using", "extern"})
    if (word(line) == other) return {};
  std::string text;
  for (std::size_t k = i; k < compiled.size() && k < i + 8; ++k) text += std::string(compiled[k]) + " ";
  const std::size_t open = text.find('('), end = text.find(';');
  if (open > end || open > text.find('{') || open == std::string::npos) return {};
  std::size_t close = open;
  for (int deep = 0; close < text.size(); ++close) {
    deep += (text[close] == '(') - (text[close] == ')');
    if (deep == 0) break;
  }
  if (text.find('{', close) == std::string::npos || end < text.find('{', close)) return {};
  const std::string before = text.substr(0, open);
  const std::string name = before.substr(before.find_last_of(" *&") + 1);
  if (name.empty() || name.find("::") != std::string::npos || before.find('=') != std::string::npos)
    return {};
  std::string types;
  int depth = 0;
  std::string one;
  const auto take = [&] {  // without its default and its name
    one = one.substr(0, one.find('='));
    while (one.ends_with(' ')) one.pop_back();
    std::size_t end = one.size();
    while (end > 0 && in_word(one[end - 1])) --end;
    if (end > 0 && one.find_first_not_of(' ') < end) one.erase(end);
    std::erase(one, ' ');
    types += (types.empty() ? "" : ", ") + one;
    one.clear();
  };
  for (std::size_t k = open + 1; k < close; ++k) {
    depth += (text[k] == '<' || text[k] == '(') - (text[k] == '>' || text[k] == ')');
    if (text[k] == ',' && depth == 0)
      take();
    else
      one += text[k];
  }
  take();
  return name + "(" + types + ")";
}

/// Files in which each type and each inline function of a named namespace is defined. Members stand indented
/// and are left out; so is what an anonymous namespace hides. clang-format writes the comments by which a
/// namespace's end is known.
using Definitions = std::map<std::string, std::set<std::string>>;

void collect(const SourceFile& file, Definitions& definitions) {
  const std::string text = code(file.text);
  const auto written = lines(file.text);
  const auto compiled = lines(text);
  std::vector<std::string> inside;
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (compiled[i].starts_with("namespace ") && compiled[i].ends_with('{')) {
      std::string_view name = compiled[i].substr(10);
      name.remove_suffix(std::min<std::size_t>(name.size(), name.ends_with(" {") ? 2 : 1));
      inside.emplace_back(name);
    } else if (written[i].starts_with("}  // namespace") && !inside.empty()) {
      inside.pop_back();
    } else if (const auto name = defined_type(compiled[i]);
               !name.empty() && std::ranges::find(inside, "") == inside.end()) {
      std::string full;
      for (const std::string& space : inside) full += space + "::";
      definitions[full + std::string(name)].insert(file.path);
    } else if (const std::string function = defined_function(compiled, i);
               !function.empty() && !inside.empty() && !function.starts_with("TEST_CASE(") &&
               std::ranges::find(inside, "") == inside.end()) {
      std::string full;
      for (const std::string& space : inside) full += space + "::";
      // What is not inline, the linker finds itself: it stands in one file, with the inline ones.
      definitions[full + function].insert(file.path);
    }
  }
}

/// A sentence for every name that two files give to different types. They may meet in one program, where the
/// linker keeps one of two template instances with the same name: the other then runs with a wrong size.
std::vector<std::string> defined_twice(const std::vector<SourceFile>& files) {
  Definitions definitions;
  for (const SourceFile& file : files) collect(file, definitions);
  std::vector<std::string> findings;
  for (const auto& [name, where] : definitions) {
    if (where.size() < 2) continue;
    std::string finding = name + " is defined in";
    for (const std::string& path : where) finding += " " + path;
    findings.push_back(finding);
  }
  return findings;
}

TEST_CASE("no two files define types, or functions, of the same name") {
  for (const std::string& finding : defined_twice(source_files())) FAIL_CHECK(finding);
}

TEST_CASE("a type defined twice is found") {
  const auto file = [](const char* path, const std::string& body) {
    return SourceFile{path, "namespace shortfall {\n" + body + "}  // namespace shortfall\n"};
  };
  const std::string type = "struct Flight {\n  int n;\n};\n";
  const auto findings = defined_twice({file("a.hpp", type), file("b.cpp", "class Flight {};\n")});
  REQUIRE(findings.size() == 1);
  CHECK(findings[0] == "shortfall::Flight is defined in a.hpp b.cpp");
  CHECK(defined_twice({file("a.hpp", type), file("b.cpp", "enum class Flight { a };\n")}).size() == 1);
  CHECK(defined_twice({file("a.hpp", type), file("b.cpp", "struct Flight;\n")}).empty());
  CHECK(defined_twice({file("a.hpp", type), file("b.cpp", "struct Flight<int> {};\n")}).empty());
  CHECK(defined_twice({file("a.hpp", type), file("b.cpp", "struct Flight::Part {};\n")}).empty());
  CHECK(defined_twice({file("a.hpp", type), file("b.cpp", "// struct Flight {\n")}).empty());
  // An inline function and another one of the same name and types: the linker keeps either.
  const std::string function =
      "std::string text(double value, const Map<int, int>& m = {}) {\n  return {};\n}\n";
  CHECK(defined_twice({file("a.hpp", "inline " + function), file("b.cpp", function)}).size() == 1);
  CHECK(defined_twice({file("a.hpp", "inline " + function),
                       file("b.cpp", "std::string text(float value, const Map<int, int>& m) {}\n")})
            .empty());
  CHECK(defined_twice({file("a.hpp", "inline " + function),
                       file("b.hpp", "std::string text(double value, const Map<int, int>& other);\n")})
            .empty());
  CHECK(defined_twice({file("a.hpp", "inline " + function),
                       file("b.cpp", "std::string Class::text(double value, const Map<int, int>& m) {}\n")})
            .empty());
  CHECK(defined_twice(
            {file("a.cpp", "namespace {\n" + function + "}  // namespace\n"), file("b.cpp", function)})
            .empty());
  const std::string hidden = "namespace {\n" + type + "}  // namespace\n";
  CHECK(defined_twice({file("a.cpp", hidden), file("b.cpp", hidden)}).empty());
  CHECK(defined_twice({file("a.cpp", hidden + type), file("b.cpp", hidden)}).empty());
}

}  // namespace
}  // namespace shortfall::house
