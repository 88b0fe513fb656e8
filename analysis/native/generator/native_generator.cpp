// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the catalogue as C++, while the project is built: native_generator FOLDER.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/cpp_emitter.hpp"

namespace {

namespace fs = std::filesystem;
using namespace shortfall;

struct Entry {
  std::string integrator, file, class_name;
};

struct Refusal {
  std::string integrator, reason;
};

/// Unchanged files keep their time, so that what includes them is not compiled again.
void write(const fs::path& path, const std::string& text) {
  std::ifstream in(path, std::ios::binary);
  if (in && std::string(std::istreambuf_iterator<char>(in), {}) == text) return;
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(path.string() + " cannot be written");
}

std::string identifier(std::string name) {
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

const std::string kHead =
    "// Written by shortfall from integrators/: every change is lost.\n#pragma once\n\n";

/// visit.template operator()<Class>("name") for every integrator of a family.
std::string family_header(const std::string& family, const std::vector<Entry>& entries) {
  std::string text = kHead;
  for (const Entry& e : entries) text += "#include \"native/" + e.file + "\"\n";
  text +=
      "\nnamespace shortfall::native {\n\n/// visit.template operator()<Class>(\"name\") for each of them.\n"
      "template <class Visit>\nvoid visit_" +
      identifier(family) + "([[maybe_unused]] const Visit& visit) {\n";
  for (const Entry& e : entries)
    text += "  visit.template operator()<" + e.class_name + ">(" + quoted(e.integrator) + ");\n";
  return text + "}\n\n}  // namespace shortfall::native\n";
}

std::string index(const std::map<std::string, std::vector<Entry>>& families) {
  std::string text = kHead;
  for (const auto& [family, entries] : families)
    text += "#include \"native/family_" + identifier(family) + ".hpp\"\n";
  text +=
      "\nnamespace shortfall::native {\n\n/// visit.template operator()<Class>(\"name\") for the whole "
      "catalogue, as far as it can be written.\n"
      "template <class Visit>\nvoid visit_catalogue(const Visit& visit) {\n";
  for (const auto& [family, entries] : families) text += "  visit_" + identifier(family) + "(visit);\n";
  return text + "}\n\n}  // namespace shortfall::native\n";
}

std::string refusals_header(const std::vector<Refusal>& refusals) {
  std::string text = kHead +
                     "#include <array>\n#include <string_view>\n\nnamespace shortfall::native {\n\n"
                     "struct Refusal {\n  std::string_view integrator;\n  std::string_view reason;\n};\n\n"
                     "/// Integrators of the catalogue that are not written as C++, and why.\n"
                     "inline constexpr std::array<Refusal, " +
                     std::to_string(refusals.size()) + "> kRefusals{";
  if (!refusals.empty()) text += "{";
  for (const Refusal& r : refusals) text += "\n    {" + quoted(r.integrator) + ", " + quoted(r.reason) + "},";
  if (!refusals.empty()) text += "}";
  return text + "};\n\n}  // namespace shortfall::native\n";
}

void generate(const fs::path& folder) {
  std::map<std::string, std::vector<Entry>> families;
  std::vector<Refusal> refusals;
  std::set<std::string> classes;
  fs::create_directories(folder);
  for (const Program& program : catalogue()) {
    std::vector<Entry>& entries = families[family(program)];
    const std::string file = fs::path(program.file).stem().string() + ".hpp";
    try {
      const CppClass c = cpp_class(program);
      if (!classes.insert(c.name).second)
        throw Error("two integrators would be the class " + c.name + ": " + program.name + " is one of them");
      write(folder / file, c.text);
      entries.push_back({program.name, file, c.name});
    } catch (const Unable& e) {
      refusals.push_back({program.name, e.what()});
      write(folder / file, std::string("// ") + e.what() + "\n");
    }
  }
  for (const auto& [family, entries] : families)
    write(folder / ("family_" + identifier(family) + ".hpp"), family_header(family, entries));
  write(folder / "index.hpp", index(families));
  write(folder / "refusals.hpp", refusals_header(refusals));
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fputs("usage: native_generator FOLDER\n", stderr);
    return 2;
  }
  generate(arguments[1]);
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "native_generator: %s\n", e.what());
  return 1;
}
