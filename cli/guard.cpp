// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/identify/identification.hpp"
#include "cli/command.hpp"
#include "cli/log_options.hpp"
#include "cli/output.hpp"
#include "notebooks-export/identify_text.hpp"

namespace shortfall::cli {

namespace {

struct GuardWords : LogWords, Question {
  std::string file;
};

/// Whether the damping number of a match is the one given, as far as the log tells.
bool is_damping(const Match& m, const Rational& given) {
  constexpr double kSpreads = 4;
  if (m.exact) {
    const double c = given.to_double();
    return std::fabs(m.flight.c - c) <= 2 * std::numeric_limits<float>::epsilon() * c;
  }
  return std::fabs(m.fit.c.value - given.to_double()) <= kSpreads * m.fit.c.spread;
}

int guard(const GuardWords& o) {
  const Log log = read_log(o.file, o.log_options());
  const Program program = o.program();
  Question question = o;
  Values values = question.values();
  IdentifyOptions options = o.identify_options(log);
  // A damping that was given is found like any other, and then compared: so a changed one is told with its
  // number.
  std::optional<Rational> damping;
  if (const auto c = values.find("c"); c != values.end()) {
    damping = c->second;
    values.erase(c);
  }
  options.only = {candidate(program, o.substep_count, values)};
  const Identification found = identify(log, options);
  const bool damped_so = !damping || found.matches.empty() || is_damping(found.matches[0], *damping);
  const bool whole = std::ranges::none_of(found.breaks, [](const Break& b) {
    return b.kind == Break::Kind::unexplained || b.kind == Break::Kind::contact ||
           b.kind == Break::Kind::limit;
  });
  const bool holds = found.kind == Identification::Kind::map && whole && damped_so;
  const std::string name = options.only[0].str();
  std::string reason;
  if (holds)
    reason = fmt::format("{} reproduces rows {} to {} of {} {}: {}", name, found.first, found.last - 1,
                         log.file, found.matches[0].exact ? "to the last bit" : "within its rounding",
                         parameters_text(log, found.matches[0]));
  else if (found.kind == Identification::Kind::map && !damped_so)
    reason = fmt::format("{} reproduces {} with another damping number than c = {}: {}", name, log.file,
                         damping->str(), parameters_text(log, found.matches[0]));
  else if (found.kind == Identification::Kind::map)
    reason = fmt::format("{} reproduces only rows {} to {} of {}: {}", name, found.first, found.last - 1,
                         log.file, found.breaks.back().text);
  else if (found.kind != Identification::Kind::none || found.nearest.empty())
    reason = fmt::format("{} does not reproduce {}: {}", name, log.file, found.advice);
  else
    reason =
        fmt::format("{} does not reproduce {}: with its best parameters ({}) it is off by {:.3g} m", name,
                    log.file, parameters_text(log, found.nearest[0]), found.nearest[0].fit.worst_position);
  if (o.json) {
    nlohmann::ordered_json result = {{"schema", "shortfall.guard/1"},
                                     {"file", log.file},
                                     {"map", name},
                                     {"holds", holds},
                                     {"reason", reason}};
    write_output(result.dump(2) + "\n", o.output);
  } else {
    write_output(reason + "\n", o.output);
  }
  return holds ? kDone : kRefuted;
}

}  // namespace

void add_guard(CLI::App& app, int& code) {
  CLI::App* command = new_command(app, "Engines", "guard",
                                  "Fails when an engine no longer makes the motion of a log: for CI.",
                                  {"guard log.csv jolt --substeps 2", "guard log.csv physx --param c=0.5"});
  auto o = std::make_shared<GuardWords>();
  command->add_option("LOG", o->file, "CSV, TSV or JSON lines")->required()->type_name("FILE");
  command->add_option("INTEGRATOR", o->integrator, "the map that it is to be")->required();
  add_log_words(*command, *o);
  add_parameters(*command, *o);
  add_json(*command, *o);
  add_output(*command, *o);
  command->callback([o, &code] { code = guard(*o); });
}

}  // namespace shortfall::cli
