// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/audit_text.hpp"

#include <algorithm>

namespace shortfall {

namespace {

std::string proof_words(const AuditClaim& c) {
  switch (c.verdict) {
    case AuditClaim::Verdict::holds:
      if (!c.proved) return "not contradicted: " + c.found;
      return c.digits > 0 ? "holds to " + std::to_string(c.digits) + " digits" : "proved";
    case AuditClaim::Verdict::refuted:
      return "refuted: " + c.found;
    case AuditClaim::Verdict::undecided:
      return "not decided: " + c.found;
  }
  return "";
}

/// The sign for rounded numbers, in ASCII where that is asked for.
std::string plain(std::string text, Style style) {
  if (style != Style::language) return text;
  static const std::string kRounded = "≈ ";
  for (std::size_t i = text.find(kRounded); i != std::string::npos; i = text.find(kRounded, i))
    text.replace(i, kRounded.size(), "~ ");
  return text;
}

std::string change_text(const Change& c) {
  if (c.printed.empty() && c.right.empty()) return c.where;
  if (c.printed.empty()) return c.where + ": " + c.right;
  if (c.where.starts_with("line ")) return c.where + ": " + c.right + "\n     printed: " + c.printed;
  return c.where + " = " + c.right + "   (printed " + c.printed + ")";
}

std::string claim_text(const Mend& m) { return m.changes[0].right + " instead of " + m.changes[0].printed; }

std::string evidence(const Mend& m) {
  std::string text = "restores " + m.restores;
  if (m.digits > 0) text += " to " + std::to_string(m.digits) + " digits";
  if (m.checks > 0)
    text += "; " + std::to_string(m.checks) +
            (m.checks == 1 ? " condition confirms it" : " conditions confirm it");
  else
    text += "; nothing else confirms it";
  return text;
}

}  // namespace

std::string kind_text(Mend::Kind kind) {
  switch (kind) {
    case Mend::Kind::entry:
      return "entry";
    case Mend::Kind::entries:
      return "entries";
    case Mend::Kind::everywhere:
      return "everywhere";
    case Mend::Kind::exchange:
      return "exchange";
    case Mend::Kind::line:
      return "line";
    case Mend::Kind::exact_value:
      return "exact value";
    case Mend::Kind::claim:
      return "claim";
  }
  return "";
}

std::string as_text(const Audit& audit, Style style) {
  std::string text = audit.name + ", " + audit.kind;
  text += audit.digits > 0
              ? ", coefficients known to " + std::to_string(audit.digits) + " digits after the point\n"
              : ", coefficients exact\n";
  std::size_t width = 0;
  for (const AuditClaim& c : audit.claims) width = std::max(width, c.claim.size());
  constexpr std::size_t kWidest = 40;
  width = std::min(width, kWidest);
  text += "\nClaims\n";
  if (audit.claims.empty()) text += "  none\n";
  for (const AuditClaim& c : audit.claims) {
    text += "  " + c.claim + std::string(width > c.claim.size() ? width - c.claim.size() : 0, ' ') + "  " +
            proof_words(c) + "\n";
    for (const std::string& reason : c.reasons) text += std::string(width + 6, ' ') + reason + "\n";
  }
  if (!audit.facts.empty()) {
    text += "\nNot claimed, and found\n";
    for (const std::string& fact : audit.facts) text += "  " + fact + "\n";
  }
  const auto is_value = [](const Mend& m) { return m.kind == Mend::Kind::exact_value; };
  if (std::ranges::any_of(audit.mends, is_value)) {
    text += "\nDecimals that probably stand for\n";
    for (const Mend& m : audit.mends)
      if (is_value(m)) {
        for (const Change& c : m.changes)
          text += "  " + c.printed + "  " + c.right + "   (" + c.where + ")\n";
        if (!m.restores.empty()) text += "  " + m.restores + "\n";
      }
  }
  int rank = 0;
  for (const Mend& m : audit.mends) {
    if (is_value(m)) continue;
    if (++rank == 1) text += "\nProbable mends, the most probable first\n";
    const std::string number = "  " + std::to_string(rank) + "  ";
    if (m.kind == Mend::Kind::claim) {
      text += number + "the claim: " + claim_text(m) + "\n";
      continue;
    }
    for (std::size_t i = 0; i < m.changes.size(); ++i) {
      constexpr std::size_t kShown = 6;
      if (i == kShown && m.changes.size() > kShown + 1) {
        text += "     and " + std::to_string(m.changes.size() - kShown) + " more\n";
        break;
      }
      text += (i == 0 ? number : std::string(number.size(), ' ')) + change_text(m.changes[i]) + "\n";
    }
    if (!m.slip.empty() && m.slip != m.changes[0].where) text += "     " + m.slip + "\n";
    text += "     " + evidence(m) + "\n";
  }
  for (const std::string& note : audit.notes) text += "\n" + note + "\n";
  return plain(std::move(text), style);
}

nlohmann::ordered_json as_json(const Audit& audit) {
  using Json = nlohmann::ordered_json;
  const auto or_null = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  Json json{{"schema", "shortfall.audit/1"},
            {"integrator", audit.name},
            {"file", audit.file},
            {"kind", audit.kind},
            {"exact", audit.digits == 0},
            {"digits", audit.digits == 0 ? Json(nullptr) : Json(audit.digits)}};
  json["claims"] = Json::array();
  for (const AuditClaim& c : audit.claims) {
    Json holds = nullptr;
    if (c.verdict != AuditClaim::Verdict::undecided) holds = c.verdict == AuditClaim::Verdict::holds;
    json["claims"].push_back({{"claim", c.claim},
                              {"holds", holds},
                              {"found", c.found},
                              {"proved", holds != nullptr && c.digits == 0 && c.proved},
                              {"digits", c.digits == 0 ? Json(nullptr) : Json(c.digits)},
                              {"stated", c.stated},
                              {"line", c.place.line == 0 ? Json(nullptr) : Json(c.place.line)},
                              {"reasons", c.reasons}});
  }
  json["found"] = audit.facts;
  json["mends"] = Json::array();
  for (const Mend& m : audit.mends) {
    Json changes = Json::array();
    for (const Change& c : m.changes)
      changes.push_back({{"where", c.where}, {"printed", or_null(c.printed)}, {"right", or_null(c.right)}});
    json["mends"].push_back({{"kind", kind_text(m.kind)},
                             {"changes", changes},
                             {"slip", or_null(m.slip)},
                             {"restores", or_null(m.restores)},
                             {"conditions_that_confirm", m.checks},
                             {"digits", m.digits == 0 ? Json(nullptr) : Json(m.digits)},
                             {"certainty", "probable"}});
  }
  json["notes"] = audit.notes;
  return json;
}

}  // namespace shortfall
