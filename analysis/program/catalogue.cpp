// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "analysis/algebra/characters.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue_data.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/suggest.hpp"
#include "analysis/program/tableau_file.hpp"
#include "analysis/program/version.hpp"

namespace shortfall {

namespace {

/// Letters and digits only, in lower case.
std::string folded(std::string_view text) {
  std::string result;
  for (unsigned char c : text)
    if (std::isalnum(c)) result += static_cast<char>(std::tolower(c));
  return result;
}

}  // namespace

const std::vector<Program>& catalogue() {
  static const std::vector<Program> programs = [] {
    std::vector<Program> all;
    for (const EmbeddedFile& file : catalogue_files())
      all.push_back(parse(file.text, std::string(file.path)));
    return all;
  }();
  return programs;
}

std::string family(const Program& program) { return program.file.substr(0, program.file.find('/')); }

Program find_integrator(const std::string& word) {
  if (word.ends_with(".integrator")) return parse_file(word);
  if (word.ends_with(".json")) return parse_tableau_file(word).program;
  // A word with a slash is an alias such as "3/8 rule" only when it is written as it stands; otherwise it is
  // a path.
  const bool path = word.find('/') != std::string::npos;
  if (const std::size_t sign = word.find('@'); sign != std::string::npos && !path)
    return of_version(find_integrator(word.substr(0, sign)), word.substr(sign + 1), catalogue());
  const auto key = path ? lower_case : folded;
  const std::string wanted = key(word);
  std::vector<std::string> near_names;
  for (const Program& p : catalogue())
    if (p.name == word) return p;
  for (const Program& p : catalogue()) {
    std::vector<std::string> names = p.aliases;
    names.insert(names.begin(), p.name);
    for (const std::string& name : names)
      if (!wanted.empty() && key(name) == wanted) return p;
    near_names.insert(near_names.end(), names.begin(), names.end());
  }
  if (path) return parse_file(word);
  const std::string near = nearest(word, near_names);
  throw BadInput("unknown integrator '" + word + "'" +
                 (near.empty() ? "" : "; did you mean '" + near + "'?") +
                 " (shortfall list shows all; a file ends in .integrator or .json)");
}

std::string word_for(const Program& program) {
  const bool is_ours = std::ranges::any_of(
      catalogue(), [&](const Program& p) { return p.name == program.name && p.file == program.file; });
  return is_ours ? program.name : program.file;
}

}  // namespace shortfall
