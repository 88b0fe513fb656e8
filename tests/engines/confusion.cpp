// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/engines/confusion.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/identification.hpp"
#include "analysis/identify/observations.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/engines/replay.hpp"

namespace shortfall::engines {
namespace {

/// The same log with rounded numbers, or without velocities.
std::string blurred(const std::string& csv, const Blur& blur) {
  std::istringstream in(csv);
  std::string line, result;
  for (int row = 0; std::getline(in, line); ++row) {
    std::istringstream cells(line);
    std::string cell, out;
    for (int column = 0; std::getline(cells, cell, ','); ++column) {
      if (column >= 5 && !blur.velocities) break;
      if (row > 0 && column >= 2 && blur.decimals >= 0) {
        char text[64];
        std::snprintf(text, sizeof text, "%.*f", blur.decimals, std::stod(cell));
        cell = text;
      }
      out += (column ? "," : "") + cell;
    }
    result += out + "\n";
  }
  return result;
}

/// Springs that an engine adds to its forces; all others it solves as joints.
bool spring_is_force(const Recording& r) {
  return r.kind == "spring_engine" &&
         (r.engine.starts_with("mujoco") || r.engine == "cannon-es" || r.engine == "chipmunk");
}

/// Recordings that no fixed step of an engine's own integrator made.
bool foreign(const Recording& r) {
  return (r.kind == "spring_engine" && !spring_is_force(r)) || r.kind.starts_with("pendulum") ||
         r.kind == "render_interpolated" || r.kind == "orbit_user" || r.kind == "variable_dt";
}

bool is_true(const Candidate& c, const Recording& r) {
  // The damping of cannon-es' spring is a force as well, not the damping of its bodies.
  const std::string name =
      spring_is_force(r) && r.engine == "cannon-es" ? "symplectic-euler" : integrator_of(r);
  if (c.name() != name) return false;
  const auto flag = c.fixed.find("d");
  if (r.explicit_damping != (flag != c.fixed.end() && flag->second.is_zero()) && r.damping != 0) return false;
  const int n = r.substeps != 0 ? r.substeps : candidate(find_integrator(name), std::nullopt).substep_count();
  return !c.counts || c.substep_count() == n;
}

/// Whether a map that was listed makes the log when it is run again.
bool faithful(const Log& log, const Identification& found, const Match& m) {
  Observations o = observations(log, found.dt.to_double(), found.first, found.last);
  for (const Break& b : found.breaks)
    if (b.kind == Break::Kind::first_frame && b.row == found.first && m.fit.launch == Launch::velocity)
      o.first_velocity = false;
  if (m.exact) return compare(m.candidate, o, m.flight).exact;
  return m.ulp <= m.allowed;
}

}  // namespace

Verdict verdict(const Recording& r, const std::string& csv, const Blur& blur) {
  Verdict v;
  v.file = r.file;
  v.engine = r.engine;
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Log log = parse_log(blurred(csv, blur), r.file);
    const Identification found = identify(log);
    v.listed = found.matches.size();
    bool truth = false, engines = false;
    for (const Match& m : found.matches) {
      if (v.answer.size() < 60) v.answer += (v.answer.empty() ? "" : "; ") + m.candidate.str();
      truth = truth || is_true(m.candidate, r);
      engines = engines || family(*m.candidate.program) == "engines";
      v.unfaithful += found.kind == Identification::Kind::map && !faithful(log, found, m);
    }
    if (foreign(r) && (!truth || found.kind != Identification::Kind::map))
      v.kind =
          engines && found.kind == Identification::Kind::map ? Verdict::Kind::wrong : Verdict::Kind::as_such;
    else if (found.matches.empty())
      v.kind = Verdict::Kind::missed;
    else if (!truth)
      v.kind = Verdict::Kind::wrong;
    else
      v.kind = found.identifiable ? Verdict::Kind::identified : Verdict::Kind::undecided;
    if (found.matches.empty())
      v.answer = found.nearest.empty() ? found.advice
                                       : "nearest " + found.nearest[0].candidate.str() + " " +
                                             std::to_string(found.nearest[0].ulp);
  } catch (const Error& e) {
    v.kind = Verdict::Kind::refused;
    v.answer = e.what();
  }
  v.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return v;
}

std::string confusion_table(const std::vector<Verdict>& verdicts) {
  using Kind = Verdict::Kind;
  std::map<std::string, std::map<Kind, int>> counts;
  double seconds = 0;
  std::size_t unfaithful = 0;
  for (const Verdict& v : verdicts) {
    ++counts[v.engine][v.kind];
    ++counts["all"][v.kind];
    seconds = std::max(seconds, v.seconds);
    unfaithful += v.unfaithful;
  }
  std::string text = "engine                identified undecided as such  missed   wrong refused\n";
  char line[400];
  for (auto& [engine, count] : counts) {
    std::snprintf(line, sizeof line, "%-22s %9d %9d %7d %7d %7d %7d\n", engine.c_str(),
                  count[Kind::identified], count[Kind::undecided], count[Kind::as_such], count[Kind::missed],
                  count[Kind::wrong], count[Kind::refused]);
    text += line;
  }
  std::snprintf(line, sizeof line,
                "listed maps that do not reproduce their log: %zu; the slowest took %.2f s\n", unfaithful,
                seconds);
  text += line;
  for (const Verdict& v : verdicts) {
    if (v.kind != Kind::wrong && v.kind != Kind::missed && v.kind != Kind::refused) continue;
    text += std::string(v.kind == Kind::wrong    ? "wrong   "
                        : v.kind == Kind::missed ? "missed  "
                                                 : "refused ") +
            v.file + ": " + v.answer + "\n";
  }
  return text;
}

}  // namespace shortfall::engines
