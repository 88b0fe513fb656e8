// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
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
};

int identify_log(const IdentifyWords& o) {
  if (o.file.empty()) throw BadInput("which log? shortfall identify log.csv");
  const Log log = read_log(o.file, o.log_options());
  const Identification found = identify(log, o.identify_options(log));
  write_output(o.json ? as_json(log, found).dump(2) + "\n" : as_text(log, found, o.all ? 100'000 : 12), o.output);
  return found.kind == Identification::Kind::map ? kDone : kRefuted;
}

}  // namespace

void add_identify(CLI::App& app, int& code) {
  CLI::App* command = new_command(app, "Engines", "identify",
                                  "Which integrator made a log of positions, with which parameters.",
                                  {"identify log.csv --dt 1/50 --g 9.81", "identify log.csv", "identify log.csv --json"});
  auto o = std::make_shared<IdentifyWords>();
  command->add_option("LOG", o->file, "CSV, TSV or JSON lines: positions, and velocities where there are any")
      ->type_name("FILE");
  add_log_words(*command, *o);
  command->add_flag("--all", o->all, "list every map that reproduces the log");
  command->add_flag("--json", o->json, "the answer as JSON");
  command->add_option("-o,--output", o->output, "write to this file")->type_name("FILE");
  command->callback([o, &code] { code = identify_log(*o); });
}

}  // namespace shortfall::cli
