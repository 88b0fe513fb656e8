// SPDX-License-Identifier: GPL-3.0-or-later
// Random slips in the steps of the catalogue's splittings and Verlet methods.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/program_audit.hpp"
#include "analysis/audit/slip.hpp"
#include "analysis/audit/text_edit.hpp"
#include "analysis/program/file_text.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// The lines of the blocks that say what a step does, counted from 0.
std::vector<std::size_t> step_lines(const std::vector<std::string>& lines) {
  std::vector<std::size_t> result;
  bool inside = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].empty() && lines[i][0] != ' ') inside = lines[i] == "step" || lines[i] == "splitting";
    if (lines[i].starts_with("  ") && (inside || lines[i].starts_with("  approx")) &&
        lines[i].find('#') == std::string::npos)
      result.push_back(i);
  }
  return result;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("a random slip in the step of an integrator is mended, in most cases by the first proposal") {
  std::vector<std::string> paths;
  for (const char* family : {"splitting", "verlet", "euler"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(SHORTFALL_SOURCE_DIR) + "/integrators/" + family))
      if (entry.path().extension() == ".integrator") paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  std::mt19937 random(2611);
  int seen = 0, first = 0, among = 0;
  constexpr int kSlips = 60;
  for (int n = 0; n < kSlips; ++n) {
    const std::string path = paths[random() % paths.size()], text = file_text(path);
    std::vector<std::string> lines = lines_of(text);
    const std::vector<std::size_t> where = step_lines(lines);
    if (where.empty()) continue;
    const std::size_t at = where[random() % where.size()];
    const std::string original = lines[at];
    // Behind the name that is assigned, or behind kick and drift.
    const std::size_t begin = original.find('=') == std::string::npos
                                  ? original.find_first_of("0123456789(-", 4)
                                  : original.find('=') + 2;
    if (begin >= original.size()) continue;
    const std::vector<std::string> slips = before_a_slip(original.substr(begin));
    lines[at] = original.substr(0, begin) + slips[random() % slips.size()];
    const std::string wrong = joined(lines);
    CAPTURE(path);
    CAPTURE(lines[at]);
    try {
      const Audit audit = audit_program(parse(wrong, path), wrong, std::nullopt);
      if (!audit.refuted()) continue;
      ++seen;
      const auto is_it = [&](const Mend& m) {
        return m.changes[0].where == "line " + std::to_string(at + 1) &&
               without_blanks(m.changes[0].right) == without_blanks(original);
      };
      first += !audit.mends.empty() && is_it(audit.mends[0]);
      among += std::ranges::any_of(audit.mends, is_it);
    } catch (const SyntaxError&) {  // the language itself sees it
    }
  }
  MESSAGE(seen << " slips are seen; the original line is the first mend of " << first
               << ", among the mends of " << among);
  CHECK(seen >= 30);
  CHECK(100 * first >= 60 * seen);
}
