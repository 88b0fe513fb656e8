// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/by_dt.hpp"
#include "analysis/identify/identification.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "cli/command.hpp"
#include "cli/correct.hpp"
#include "cli/log_options.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/figure_residuals.hpp"
#include "notebooks-export/identify_text.hpp"

namespace shortfall::cli {

namespace {

struct IdentifyWords : LogWords {
  std::string file;
  bool all = false;
  bool json = false;
  std::string output, plot, language;
  std::vector<std::string> by_dt, own;
};

/// "30Hz:165px": a step and what was seen with it, in units that stay as they are.
int identify_by_dt(const IdentifyWords& o) {
  std::vector<ByDtPoint> points;
  std::string unit;
  for (const std::string& word : o.by_dt) {
    const std::size_t colon = word.find(':');
    if (colon == std::string::npos)
      throw BadInput("--by-dt '" + word.substr(0, 60) + "': write STEP:VALUE, as in 60Hz:150px");
    const std::string value = word.substr(colon + 1);
    const std::size_t end = value.find_last_of("0123456789.") + 1;
    if (!points.empty() && value.substr(end) != unit)
      throw BadInput("--by-dt: the values have different units");
    unit = value.substr(end);
    points.push_back({positive_quantity(word.substr(0, colon), Unit::time, "--by-dt"),
                      quantity(value.substr(0, end), Unit::none, "--by-dt")});
  }
  std::optional<double> g;
  if (!o.g.empty()) g = positive_quantity(o.g, Unit::none, "--g").to_double();
  const ByDt r = by_dt(points, g);
  if (o.json) {
    nlohmann::ordered_json j = {{"schema", "shortfall.identify/1"},
                                {"kind", "by-dt"},
                                {"unit", unit},
                                {"order", r.order},
                                {"limit", r.limit},
                                {"slope", r.slope},
                                {"misfit", r.misfit},
                                {"candidates", nlohmann::ordered_json::array()}};
    for (const std::string& m : r.maps) j["candidates"].push_back({{"map", m}});
    write_output(j.dump(2) + "\n", o.output);
    return kDone;
  }
  std::string text = fmt::format("order   {:.4g}{}\nlimit   {:.6g} {} at a step of 0\n", r.order,
                                 r.whole_order ? "" : " (no whole number)", r.limit, unit);
  text +=
      fmt::format("error   {:+.6g} {}/s^{:.3g} times dt^{:.3g}: {}; the points are off by {:.2g} at most\n",
                  r.slope, unit, r.order, r.order, r.slope > 0 ? "too much" : "too little", r.misfit);
  if (r.order == 1) {
    text +=
        r.slope > 0
            ? "method  the position moves with the velocity of the step before: it drifts before it kicks\n"
            : "method  the velocity is changed before the position moves: it kicks before it drifts\n";
    if (r.share)
      text += fmt::format("        the error is {:.3g} times half a step of launch velocity\n", *r.share);
    std::string maps;
    for (const std::string& m : r.maps) maps += (maps.empty() ? "" : "; ") + m;
    text += "        such are: " + (maps.empty() ? "none that is known" : maps) + "\n";
  }
  write_output(text, o.output);
  return kDone;
}

/// What a user would ask `shortfall correct` about the map that was found.
Question correction_question(const Identification& found, const Match& m) {
  Question q;
  q.integrator = word_for(*m.candidate.program);
  q.dt = found.dt.str();
  if (m.candidate.substep_count() > 1) q.substep_count = m.candidate.substep_count();
  for (const auto& [name, value] : m.candidate.fixed)
    if (name != "N") q.parameters.push_back(name + "=" + value.str());
  const auto told = [](const std::optional<Rational>& exact, const Fitted& fitted) {
    return exact ? exact->str() : Rational::parse(fmt::format("{:.9g}", fitted.value)).str();
  };
  const bool damped = m.fit.c.value != 0 && !(m.c && m.c->is_zero());
  const bool spring = m.fit.k.value != 0 && !(m.k && m.k->is_zero());
  const std::string c = told(m.c, m.fit.c), k = told(m.k, m.fit.k);
  if (m.candidate.own_damping) q.parameters.push_back("c=" + (damped ? c : std::string("0")));
  const bool drag = damped && !m.candidate.own_damping;
  if (spring)
    q.force = drag ? "damped-spring:k=" + k + ",c=" + c : "spring:k=" + k;
  else if (drag)
    q.force = "constant+drag:c=" + c;
  return q;
}

/// The same as the user would type it.
std::string typed(const Question& q) {
  std::string text = "shortfall correct " + q.integrator;
  if (q.force != "constant") text += " --force " + q.force;
  if (q.substep_count) text += fmt::format(" --substeps {}", *q.substep_count);
  for (const std::string& p : q.parameters) text += " --param " + p;
  return text + " --dt " + q.dt;
}

/// The kit for the map that was found; of several that are the same map, for the first.
std::string repair_text(const Identification& found) {
  if (!found.identifiable) return "";
  const Question q = correction_question(found, found.matches.front());
  std::string text = "\nWhat repairs it (" + typed(q) + ")\n";
  try {
    std::istringstream lines(correction_answer(q).text);
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  } catch (const Error& e) {
    text += std::string("  none: ") + e.what() + "\n";
  }
  return text;
}

int identify_log(const IdentifyWords& o) {
  if (!o.by_dt.empty()) return identify_by_dt(o);
  if (o.file.empty()) throw BadInput("which log? shortfall identify log.csv");
  check_picture_name(o.plot);
  const Log log = read_log(o.file, o.log_options());
  IdentifyOptions options = o.identify_options(log);
  // Candidates point to their programs.
  std::vector<Program> own;
  for (const std::string& file : o.own) own.push_back(parse_file(file));
  if (!own.empty()) options.only = known_candidates();
  for (const Program& program : own)
    for (const Candidate& c : candidates_of(program)) options.only.push_back(c);
  const Identification found = identify(log, options);
  if (!o.plot.empty()) write_picture(residual_figure(log, found), o.plot);
  if (!o.language.empty()) {
    if (found.kind != Identification::Kind::map || !found.identifiable)
      throw Unable(
          "code is printed for the one map that makes a log; this one " +
          (found.matches.empty() ? "no map makes" : fmt::format("{} different maps make", found.groups)));
    write_output(correction_code(correction_question(found, found.matches.front()), o.language, ""),
                 o.output);
    return kDone;
  }
  if (o.json) {
    auto json = as_json(log, found);
    json["repair"] = nullptr;
    if (found.identifiable) json["repair"] = typed(correction_question(found, found.matches.front()));
    write_output(json.dump(2) + "\n", o.output);
  } else {
    write_output(as_text(log, found, o.all ? 100'000 : 12) + repair_text(found), o.output);
  }
  return found.kind == Identification::Kind::map ? kDone : kRefuted;
}

}  // namespace

void add_identify(CLI::App& app, int& code) {
  CLI::App* command = new_command(app, "Engines", "identify",
                                  "Which integrator made a log of positions, with which parameters.",
                                  {"identify log.csv --dt 1/50 --g 9.81", "identify log.csv",
                                   "identify log.csv --plot residuals.svg", "identify log.csv --lang csharp",
                                   "identify log.csv --with my-own.integrator", "identify log.csv --json"});
  auto o = std::make_shared<IdentifyWords>();
  command->add_option("LOG", o->file, "CSV, TSV or JSON lines: positions, and velocities where there are any")
      ->type_name("FILE");
  command
      ->add_option("--by-dt", o->by_dt,
                   "instead of a log: peaks at several steps, 30Hz:165px 60Hz:150px 120Hz:142.5px")
      ->type_name("STEP:VALUE");
  add_log_words(*command, *o);
  command
      ->add_option("--plot", o->plot, "what the maps leave unexplained, frame by frame: .svg, .png or .pdf")
      ->type_name("FILE");
  command
      ->add_option(
          "--lang", o->language,
          "when one map was found, what repairs it as code: csharp, cpp, gdscript, python, rust, javascript")
      ->type_name("L");
  command->add_option("--with", o->own, "also hold this integrator of yours against the log; may be repeated")
      ->type_name("FILE");
  command->add_flag("--all", o->all, "list every map that reproduces the log");
  command->add_flag("--json", o->json, "the answer as JSON");
  command->add_option("-o,--output", o->output, "write to this file")->type_name("FILE");
  command->callback([o, &code] { code = identify_log(*o); });
}

}  // namespace shortfall::cli
