// SPDX-License-Identifier: GPL-3.0-or-later
// The planted misprints are found, and the most probable mend is the one that misprints.json names.
#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/program_audit.hpp"
#include "analysis/audit/tableau_audit.hpp"
#include "analysis/program/file_text.hpp"
#include "analysis/program/json_text.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

const std::string kFolder = std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/misprints/";

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// Equal as numbers where they are numbers, else letter by letter.
bool same_value(const std::string& a, const std::string& b) {
  try {
    return Rational::parse(a) == Rational::parse(b);
  } catch (const Error&) {
    return without_blanks(a) == without_blanks(b);
  }
}

Audit audited(const std::string& file, const JsonValue& misprint) {
  if (file.ends_with(".json")) return audit_tableau(parse_tableau_file(kFolder + file));
  const int order = std::stoi(misprint.find("order")->text);
  return audit_program(parse_file(kFolder + file), file_text(kFolder + file),
                       OrderDemand{order, &force_class("a(x, t)")});
}

bool says(const Mend& mend, const JsonValue& wanted) {
  const std::string right = wanted.find("right") ? wanted.find("right")->text : "";
  if (const JsonValue* entry = wanted.find("entry"))
    return std::ranges::any_of(
        mend.changes, [&](const Change& c) { return c.where == entry->text && same_value(c.right, right); });
  if (wanted.find("everywhere"))
    return mend.kind == Mend::Kind::everywhere && same_value(mend.changes.at(0).right, right);
  if (const JsonValue* line = wanted.find("line"))
    return std::ranges::any_of(mend.changes, [&](const Change& c) {
      return c.where == "line " + line->text && without_blanks(c.right) == without_blanks(right);
    });
  if (wanted.find("exchange"))
    return mend.kind == Mend::Kind::exchange && mend.slip.ends_with("are exchanged");
  if (const JsonValue* claim = wanted.find("claim")) {
    std::string word = claim->text;
    std::ranges::replace(word, '_', ' ');
    const std::string said = right == "false" ? "not " + word : word + " " + right;
    return mend.kind == Mend::Kind::claim && mend.changes.at(0).right.starts_with(said);
  }
  return false;
}

}  // namespace

TEST_CASE("the first mend of every planted misprint is the right one" * doctest::test_suite("thorough")) {
  const Source list("misprints.json", file_text(kFolder + "misprints.json"));
  int found = 0, all = 0;
  for (const JsonValue& misprint : json_value(list).items) {
    const std::string file = misprint.find("file")->text;
    CAPTURE(file);
    const Audit audit = audited(file, misprint);
    ++all;
    CHECK(audit.refuted());
    REQUIRE_FALSE(audit.mends.empty());
    const auto first =
        std::ranges::find_if(audit.mends, [](const Mend& m) { return m.kind != Mend::Kind::exact_value; });
    REQUIRE(first != audit.mends.end());
    CAPTURE(first->changes.at(0).where);
    CAPTURE(first->changes.at(0).right);
    const auto& wanted = misprint.find("mend")->items;
    const bool right = std::ranges::all_of(wanted, [&](const JsonValue& w) { return says(*first, w); });
    CHECK(right);
    found += right;
    if (first->kind != Mend::Kind::claim) CHECK(first->restores == "every claim");
  }
  MESSAGE(found << " of " << all << " planted misprints are mended by the first proposal");
  CHECK(all >= 40);
}

TEST_CASE("a mend says what slip it undoes, and what confirms it") {
  const Audit audit = audit_tableau(parse_tableau_file(kFolder + "dormand-prince-54-digits.json"));
  REQUIRE(audit.mends.size() == 1);
  CHECK(audit.mends[0].slip == "two digits change places");
  CHECK(audit.mends[0].checks == 21);
  CHECK(audit.mends[0].digits == 0);
  const auto order =
      std::ranges::find_if(audit.claims, [](const AuditClaim& c) { return c.claim == "order 5"; });
  REQUIRE(order != audit.claims.end());
  CHECK(order->found == "order 1");
  // b A 1 is wrong by b_5 times the entry's error, -2187/6784 * (19732 - 19372)/6561.
  const Rational error = Rational(-2187, 6784) * Rational(19732 - 19372, 6561);
  CHECK(order->reasons.at(0).ends_with("off by " + error.str()));
}
