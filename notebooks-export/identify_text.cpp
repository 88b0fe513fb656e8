// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/identify_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "analysis/program/version.hpp"

namespace shortfall {

namespace {

using FindingKind = Identification::Kind;

const char* kind_word(FindingKind kind) {
  switch (kind) {
    case FindingKind::map:
      return "map";
    case FindingKind::joint:
      return "joint";
    case FindingKind::unequal_steps:
      return "unequal-steps";
    case FindingKind::resampled:
      return "resampled";
    case FindingKind::none:
      break;
  }
  return "none";
}

const char* break_word(Break::Kind kind) {
  switch (kind) {
    case Break::Kind::rest_before:
      return "rest";
    case Break::Kind::first_frame:
      return "first-frame";
    case Break::Kind::sleep:
      return "sleep";
    case Break::Kind::limit:
      return "limit";
    case Break::Kind::contact:
      return "contact";
    case Break::Kind::unexplained:
      break;
  }
  return "unexplained";
}

/// A number that was found, or a value with how far it can be wrong.
std::string found_number(const std::optional<Rational>& exact, const Fitted& fitted) {
  if (exact) {
    const std::string decimal = exact->significant(12);
    if (Rational::parse(decimal) == *exact) return fmt::format("{:.12g}", exact->to_double());
    return exact->str();
  }
  if (!std::isfinite(fitted.spread)) return "not told";
  const int digits = fitted.value == 0
                         ? 2
                         : std::max(1, static_cast<int>(std::ceil(std::log10(
                                           std::fabs(fitted.value) / std::max(fitted.spread, 1e-300)))) +
                                           1);
  return fmt::format("{:.{}g} +- {:.1g}", fitted.value, std::min(digits, 12), fitted.spread);
}

std::string difference(const Identification& found, const Match& m) {
  if (m.exact) return "0 ulp";
  return fmt::format("{:.3g} {}", m.ulp, found.bits ? "ulp" : "of the last digit");
}

/// Whether the listed maps make the same motion with different damping numbers of their own.
bool damping_numbers_differ(const Identification& found) {
  const Match* first = nullptr;
  for (const Match& m : found.matches) {
    if (!m.candidate.own_damping || (m.c && m.c->is_zero())) continue;
    if (first && std::fabs(m.fit.c.value - first->fit.c.value) > 1e-3 * std::fabs(first->fit.c.value))
      return true;
    if (!first) first = &m;
  }
  return false;
}

std::string versions_text(const Program& program) {
  const auto all = versions(program);
  return all.empty() ? "" : all.front().text;
}

}  // namespace

std::string parameters_text(const Log& log, const Match& m) {
  std::string text;
  const auto put = [&](const std::string& name, const std::optional<Rational>& exact, const Fitted& fitted) {
    if (exact && exact->is_zero()) return;
    if (!exact && fitted.value == 0) return;
    text += (text.empty() ? "" : ", ") + name + " = " + found_number(exact, fitted);
  };
  put(m.candidate.own_damping ? "c" : "drag c", m.c, m.fit.c);
  put("k", m.k, m.fit.k);
  for (const int axis : log.axes) {
    const auto i = static_cast<std::size_t>(axis);
    put("a_" + std::string(1, static_cast<char>('x' + axis)), m.a[i], m.fit.a[i]);
  }
  return text.empty() ? "no force" : text;
}

std::string as_text(const Log& log, const Identification& found, std::size_t most) {
  std::string text = fmt::format("{}: {} rows, {}", log.file, log.rows.size(), log.position_rounding.str());
  text += log.velocities ? ", with velocities" : ", positions only";
  if (found.dt.sign() > 0) text += fmt::format(", dt = {} s ({})", found.dt.str(), found.dt_source);
  text += "\n";
  if (log.more) text += fmt::format("  the file goes on; the first {} frames were read\n", log.rows.size());
  if (log.bodies.size() > 1)
    text += fmt::format("  {} bodies; this is '{}' (--body chooses another)\n", log.bodies.size(),
                        log.bodies.front());
  for (const Break& b : found.breaks)
    text += fmt::format("  break at row {} (line {}): {}\n", b.row,
                        log.rows[std::min(b.row, log.rows.size() - 1)].line, b.text);
  text += "\n";
  if (found.kind != FindingKind::map) {
    text += "No map: " + found.advice + ".\n";
    for (const Match& m : found.matches)
      text += fmt::format("  {:<32} {:<24} {}\n", m.candidate.str(), difference(found, m),
                          parameters_text(log, m));
    if (!found.nearest.empty() && found.kind == FindingKind::none) {
      text += "\nNearest, and refuted\n";
      for (const Match& m : found.nearest)
        text += fmt::format("  {:<32} off by {}\n", m.candidate.str(), difference(found, m));
    }
    return text;
  }
  const std::size_t rows = found.last - found.first;
  text += fmt::format("{} of {} maps reproduce {} rows {}\n", found.matches.size(), found.candidates, rows,
                      found.matches.front().exact ? "to the last bit"
                      : found.bits                ? "as far as rounding tells"
                                                  : "within the rounding of the log");
  std::size_t listed = 0;
  for (const Match& m : found.matches) {
    if (++listed > most) {
      text += fmt::format("  and {} more (--all lists them)\n", found.matches.size() - most);
      break;
    }
    text += fmt::format("  {:<32} {:<24} {}{}\n", m.candidate.str(), difference(found, m),
                        parameters_text(log, m),
                        m.fit.launch == Launch::impulse ? ", launched by an impulse" : "");
  }
  if (found.matches.size() == 1 && !versions_text(*found.matches[0].candidate.program).empty())
    text += fmt::format("  as read in {}\n", versions_text(*found.matches[0].candidate.program));
  text += "\n";
  if (found.identifiable)
    text += found.matches.size() == 1 ? "Identified: no other map that is known makes this log.\n"
                                      : "Identified: these are one and the same map.\n";
  else
    text += fmt::format("Undecided: {} different maps make this log. To tell them apart {}.\n", found.groups,
                        found.advice.empty() ? "takes another experiment" : found.advice);
  if (!found.identifiable && damping_numbers_differ(found))
    text +=
        "If you know the damping number that was typed, it tells some of them apart: each lists the number "
        "that it takes.\n";
  if (!found.nearest.empty()) {
    text += "\nNearest of the others\n";
    for (const Match& m : found.nearest)
      text += fmt::format("  {:<32} off by {}\n", m.candidate.str(), difference(found, m));
  }
  return text;
}

nlohmann::ordered_json as_json(const Log& log, const Identification& found) {
  using json = nlohmann::ordered_json;
  json result = {{"schema", "shortfall.identify/1"},
                 {"file", log.file},
                 {"kind", kind_word(found.kind)},
                 {"rows", log.rows.size()},
                 {"rounding", log.position_rounding.str()},
                 {"velocities", log.velocities},
                 {"dt", found.dt.str()},
                 {"dt_source", found.dt_source},
                 {"first", found.first},
                 {"last", found.last},
                 {"identifiable", found.identifiable},
                 {"groups", found.groups},
                 {"advice", found.advice},
                 {"tried", found.candidates}};
  result["breaks"] = json::array();
  for (const Break& b : found.breaks)
    result["breaks"].push_back({{"kind", break_word(b.kind)}, {"row", b.row}, {"text", b.text}});
  std::map<int, std::vector<std::string>> groups;
  for (const Match& m : found.matches) groups[m.group].push_back(m.candidate.str());
  const auto described = [&](const Match& m, bool listed) {
    json c = {{"map", m.candidate.name()},
              {"substeps", m.candidate.substep_count()},
              {"ulp", m.exact ? 0 : m.ulp},
              {"exact", m.exact},
              {"launch", m.fit.launch == Launch::impulse ? "impulse" : "velocity"}};
    json parameters = json::object();
    for (const auto& [name, value] : m.candidate.fixed) parameters[name] = value.str();
    const auto put = [&](const std::string& name, const std::optional<Rational>& exact,
                         const Fitted& fitted) {
      if (exact)
        parameters[name] = exact->str();
      else
        parameters[name] = {{"decimal", fmt::format("{:.17g}", fitted.value)},
                            {"spread", std::isfinite(fitted.spread) ? json(fitted.spread) : json(nullptr)}};
    };
    put("c", m.c, m.fit.c);
    put("k", m.k, m.fit.k);
    for (const int axis : log.axes) {
      const auto i = static_cast<std::size_t>(axis);
      put("a_" + std::string(1, static_cast<char>('x' + axis)), m.a[i], m.fit.a[i]);
    }
    c["parameters"] = parameters;
    if (listed) {
      c["equivalent"] = json::array();
      for (const std::string& other : groups[m.group])
        if (other != m.candidate.str()) c["equivalent"].push_back(other);
      c["group"] = m.group;
    }
    return c;
  };
  result["candidates"] = json::array();
  for (const Match& m : found.matches) result["candidates"].push_back(described(m, true));
  result["nearest"] = json::array();
  for (const Match& m : found.nearest) result["nearest"].push_back(described(m, false));
  return result;
}

}  // namespace shortfall
