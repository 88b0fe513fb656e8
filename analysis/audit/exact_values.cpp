// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/exact_values.hpp"

#include <algorithm>
#include <map>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/known_number.hpp"
#include "analysis/audit/tableau_claims.hpp"

namespace shortfall {

namespace {

std::string quoted(const std::vector<std::string>& row) {
  std::string text;
  for (const std::string& entry : row) text += (text.empty() ? "\"" : ", \"") + entry + "\"";
  return "[" + text + "]";
}

/// A file with these entries, all exact.
std::string exact_file(const AuditedTableau& t, const Method<std::string>& m) {
  std::string rows;
  for (const auto& row : m.a) rows += (rows.empty() ? "" : ", ") + quoted(row);
  std::string text = "{\"name\": \"" + t.name + "\", \"decimals\": \"exact\"";
  text += t.nystroem ? ", \"kind\": \"nystroem\", \"Abar\": [" : ", \"A\": [";
  text += rows + "], \"b\": " + quoted(m.b);
  if (t.nystroem) text += ", \"bbar\": " + quoted(m.b_position);
  if (!m.embedded.empty()) text += ", \"bhat\": " + quoted(m.embedded);
  if (!m.embedded_position.empty()) text += ", \"bbarhat\": " + quoted(m.embedded_position);
  if (t.c_given) text += ", \"c\": " + quoted(m.c);
  return text + "}";
}

}  // namespace

std::optional<Mend> exact_values(const AuditedTableau& t, const AuditLimits& limits) {
  if (t.numbers != AuditedTableau::Numbers::digits) return std::nullopt;
  std::map<std::string, std::vector<Cell>> by_text;
  for (const Cell& cell : cells(t.texts))
    if (t.places.at(cell) > 0 && (t.c_given || cell.part != Cell::Part::c))
      by_text[t.texts.at(cell)].push_back(cell);
  Mend mend;
  mend.kind = Mend::Kind::exact_value;
  Method<std::string> exact = t.texts;
  bool all = true;
  int done = 0;
  for (const auto& [text, where] : by_text) {
    if (limits.progress) limits.progress("recognising decimals", ++done, static_cast<int>(by_text.size()));
    const auto known = known_number(t.digits.at(where.front()).ball().midpoint(), t.places.at(where.front()),
                                    static_cast<int>(by_text.size()));
    all = all && known && known->degree <= 2;
    if (!known) continue;
    const std::string more =
        where.size() > 1 ? " and " + std::to_string(where.size() - 1) + " more" : std::string();
    mend.changes.push_back({cell_name(where.front(), t.nystroem) + more, text, known->text});
    for (const Cell& cell : where) exact.at(cell) = known->text;
  }
  if (mend.changes.empty()) return std::nullopt;
  if (!all) return mend;
  AuditedTableau again(parse_tableau(exact_file(t, exact), t.program.file));
  again.claims = t.claims;
  const TableauFindings found = findings(again, limits);
  const auto verdict = [&](AuditClaim::Verdict v) {
    return std::ranges::any_of(found.claims, [&](const AuditClaim& c) { return c.verdict == v; });
  };
  if (verdict(AuditClaim::Verdict::refuted)) return std::nullopt;
  if (!verdict(AuditClaim::Verdict::undecided)) mend.restores = "with these every claim is proved";
  return mend;
}

}  // namespace shortfall
