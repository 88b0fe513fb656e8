// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/by_dt.hpp"
#include "analysis/identify/identification.hpp"
#include "cli/command.hpp"
#include "cli/log_options.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/identify_text.hpp"

namespace shortfall::cli {

namespace {

struct IdentifyWords : LogWords {
  std::string file;
  bool all = false;
  bool json = false;
  std::string output;
  std::vector<std::string> by_dt;
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

int identify_log(const IdentifyWords& o) {
  if (!o.by_dt.empty()) return identify_by_dt(o);
  if (o.file.empty()) throw BadInput("which log? shortfall identify log.csv");
  const Log log = read_log(o.file, o.log_options());
  const Identification found = identify(log, o.identify_options(log));
  write_output(o.json ? as_json(log, found).dump(2) + "\n" : as_text(log, found, o.all ? 100'000 : 12),
               o.output);
  return found.kind == Identification::Kind::map ? kDone : kRefuted;
}

}  // namespace

void add_identify(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Engines", "identify", "Which integrator made a log of positions, with which parameters.",
      {"identify log.csv --dt 1/50 --g 9.81", "identify log.csv", "identify log.csv --json"});
  auto o = std::make_shared<IdentifyWords>();
  command->add_option("LOG", o->file, "CSV, TSV or JSON lines: positions, and velocities where there are any")
      ->type_name("FILE");
  command
      ->add_option("--by-dt", o->by_dt,
                   "instead of a log: peaks at several steps, 30Hz:165px 60Hz:150px 120Hz:142.5px")
      ->type_name("STEP:VALUE");
  add_log_words(*command, *o);
  command->add_flag("--all", o->all, "list every map that reproduces the log");
  command->add_flag("--json", o->json, "the answer as JSON");
  command->add_option("-o,--output", o->output, "write to this file")->type_name("FILE");
  command->callback([o, &code] { code = identify_log(*o); });
}

}  // namespace shortfall::cli
