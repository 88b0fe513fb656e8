// SPDX-License-Identifier: GPL-3.0-or-later
// A random slip in a random entry of a random published method: how often is the first mend the original?
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/slip.hpp"
#include "analysis/audit/tableau_audit.hpp"
#include "analysis/program/file_text.hpp"

using namespace shortfall;

namespace {

struct Place2 {
  std::string name;
  const TableauEntry* entry;
};

std::vector<Place2> entries(const TableauFile& f) {
  std::vector<Place2> all;
  const auto index = [](std::size_t i) { return "[" + std::to_string(i + 1) + "]"; };
  for (std::size_t i = 0; i < f.a.size(); ++i)
    for (std::size_t j = 0; j < f.a[i].size(); ++j)
      all.push_back({(f.nystroem ? "Abar" : "A") + index(i) + index(j), &f.a[i][j]});
  for (std::size_t i = 0; i < f.b.size(); ++i) all.push_back({"b" + index(i), &f.b[i]});
  for (std::size_t i = 0; i < f.embedded.size(); ++i) all.push_back({"bhat" + index(i), &f.embedded[i]});
  for (std::size_t i = 0; i < f.c.size() && f.c_given; ++i) all.push_back({"c" + index(i), &f.c[i]});
  return all;
}

/// A digit, a pair of digits, a sign.
std::string with_a_slip(std::string text, std::mt19937& random) {
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  const std::size_t at = digits[random() % digits.size()];
  switch (random() % 4) {
    case 0:
      return text.starts_with('-') ? text.substr(1) : "-" + text;
    case 1:
      if (at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9') {
        std::swap(text[at], text[at + 1]);
        return text;
      }
      [[fallthrough]];
    case 2:
      text[at] = static_cast<char>('0' + (text[at] - '0' + 1 + static_cast<int>(random() % 9)) % 10);
      return text;
    default:
      text.insert(at, 1, text[at]);
      return text;
  }
}

/// The file with one entry written otherwise; "" when it does not stand where its place says.
std::string replaced(const std::string& text, const TableauEntry& entry, const std::string& by) {
  std::size_t begin = 0;
  for (int line = 1; line < entry.place.line; ++line) begin = text.find('\n', begin) + 1;
  begin += static_cast<std::size_t>(entry.place.column) - 1;
  if (text.compare(begin, entry.text.size(), entry.text) != 0) return "";
  const bool quoted = begin > 0 && text[begin - 1] == '"';
  const std::string put = quoted ? by : "\"" + by + "\"";
  return text.substr(0, begin) + put + text.substr(begin + entry.text.size());
}

bool same_value(const std::string& a, const std::string& b) {
  try {
    return Rational::parse(a) == Rational::parse(b);
  } catch (const Error&) {
    return a == b;
  }
}

}  // namespace

TEST_CASE("the first mend of a random slip is the original, in most cases") {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods"))
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  std::mt19937 random(1125);
  int seen = 0, first = 0, among = 0, unseen = 0;
  constexpr int kSlips = 400;
  for (int n = 0; n < kSlips; ++n) {
    const std::string path = paths[random() % paths.size()], text = file_text(path);
    const TableauFile file = parse_tableau(text, path);
    const std::vector<Place2> all = entries(file);
    const Place2& where = all[random() % all.size()];
    if (where.entry->exact && where.entry->exact->is_zero()) continue;
    const std::string wrong = with_a_slip(where.entry->text, random);
    if (wrong == where.entry->text) continue;
    const std::string mutated = replaced(text, *where.entry, wrong);
    if (mutated.empty()) continue;
    CAPTURE(path);
    CAPTURE(where.name);
    CAPTURE(wrong);
    Audit audit;
    try {
      audit = audit_tableau(parse_tableau(mutated, path));
    } catch (const SyntaxError&) {  // a denominator 0
      continue;
    }
    if (!audit.refuted()) {  // beyond the digits known, or the same number
      ++unseen;
      continue;
    }
    ++seen;
    std::erase_if(audit.mends, [](const Mend& m) { return m.kind == Mend::Kind::exact_value; });
    const auto is_it = [&](const Mend& m) {
      return m.changes.size() == 1 && m.changes[0].where == where.name &&
             same_value(m.changes[0].right, where.entry->text);
    };
    const bool is_first = !audit.mends.empty() && is_it(audit.mends[0]);
    first += is_first;
    among += std::ranges::any_of(audit.mends, is_it);
  }
  MESSAGE(seen << " slips are seen (" << unseen << " are not); the original is the first mend of " << first
               << ", among the mends of " << among);
  CHECK(seen >= 200);
  CHECK(100 * first >= 90 * seen);
  CHECK(100 * among >= 92 * seen);
}
