// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/catalogue.hpp"

#include <cctype>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue_data.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/suggest.hpp"

namespace shortfall {

namespace {

std::string folded(const std::string& text) {
  std::string result;
  for (unsigned char c : text)
    if (std::isalnum(c)) result += static_cast<char>(std::tolower(c));
  return result;
}

}  // namespace

const std::vector<Program>& catalogue() {
  static const std::vector<Program> programs = [] {
    std::vector<Program> all;
    for (const CatalogueFile& file : catalogue_files())
      all.push_back(parse(file.text, std::string(file.path)));
    return all;
  }();
  return programs;
}

std::string family(const Program& program) { return program.file.substr(0, program.file.find('/')); }

Program find_integrator(const std::string& word) {
  if (word.ends_with(".integrator") || word.find('/') != std::string::npos) return parse_file(word);
  std::vector<std::string> names;
  for (const Program& p : catalogue()) {
    if (p.name == word) return p;
    names.push_back(p.name);
  }
  const std::string wanted = folded(word);
  for (const Program& p : catalogue()) {
    if (folded(p.name) == wanted) return p;
    for (const std::string& alias : p.aliases)
      if (folded(alias) == wanted) return p;
  }
  const std::string near = nearest(word, names);
  throw BadInput("unknown integrator '" + word + "'" +
                 (near.empty() ? "" : "; did you mean '" + near + "'?") +
                 " (shortfall list shows all; a file ends in .integrator)");
}

}  // namespace shortfall
