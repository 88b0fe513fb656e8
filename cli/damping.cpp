// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/damping_report.hpp"
#include "analysis/program/catalogue.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "notebooks-export/damping_code.hpp"
#include "notebooks-export/damping_text.hpp"

namespace shortfall::cli {

namespace {

struct DampingOptions : Question {
  std::string language;
  bool all_engines = false;
};

void one(const DampingOptions& o) {
  const DampingReport r = damping_report(o.program(), o.values(), o.step(), o.gravity(), o.substeps());
  write_output(o.json ? as_json(r).dump(2) + "\n" : as_text(r, o.ascii ? Style::language : Style::unicode),
               o.output);
}

/// Every integrator of the family of engines, with the same numbers.
void all(const DampingOptions& o) {
  std::vector<DampingReport> reports;
  std::vector<std::pair<std::string, std::string>> refused;
  for (const Program& program : catalogue()) {
    if (family(program) != "engines") continue;
    Values values = o.values();
    std::erase_if(values, [&](const auto& v) { return !program.parameter(v.first); });
    try {
      reports.push_back(damping_report(program, values, o.step(), o.gravity(), o.substeps()));
    } catch (const Error& e) {
      refused.emplace_back(program.name, e.what());
    }
  }
  write_output(o.json ? damping_table_json(reports, refused).dump(2) + "\n"
                      : damping_table(reports, refused, o.ascii ? Style::language : Style::unicode),
               o.output);
}

void damping(const DampingOptions& o) {
  if (!o.language.empty()) {
    write_output(damping_code(language_of(o.language)), o.output);
  } else if (o.all_engines) {
    all(o);
  } else {
    one(o);
  }
}

}  // namespace

void add_damping(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Engines", "damping",
                  "What a damping number does: terminal speed, what is left after 1 s, at other rates, in "
                  "other conventions.",
                  {"damping godot --param c=0.5 --dt 60Hz", "damping --all-engines --param c=0.5 --dt 60Hz",
                   "damping bullet --param c=0.5 --json", "damping --lang gdscript"});
  auto o = std::make_shared<DampingOptions>();
  o->integrator = "godot";
  add_integrator(*command, *o);
  add_parameters(*command, *o);
  add_time_step(*command, *o);
  add_gravity(*command, *o);
  command->add_flag("--all-engines", o->all_engines, "a table of all engines, with the same numbers");
  command
      ->add_option(
          "--lang", o->language,
          "exact damping of v and x, the same at every rate, as code: csharp, cpp, gdscript, python, rust, "
          "javascript")
      ->type_name("L");
  add_json(*command, *o);
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o] { damping(*o); });
}

}  // namespace shortfall::cli
