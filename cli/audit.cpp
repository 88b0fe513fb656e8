// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/algebra/error.hpp"
#include "analysis/audit/program_audit.hpp"
#include "analysis/audit/tableau_audit.hpp"
#include "analysis/program/file_text.hpp"
#include "cli/command.hpp"
#include "cli/memory.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "notebooks-export/audit_text.hpp"

namespace shortfall::cli {

namespace {

struct AuditOptions : Question {
  std::string memory = "500MB";
  std::optional<int> order;
  std::string forces = "a(x, t)";
};

bool is_tableau(const std::string& path) { return path.ends_with(".json"); }

bool is_path(const std::string& word) {
  return word.ends_with(".integrator") || word.find('/') != std::string::npos;
}

Audit of_file(const AuditOptions& o, const AuditLimits& limits) {
  if (o.order && (*o.order < 1 || *o.order > kHighestClaimedOrder))
    throw BadInput("--order takes a whole number from 1 to " + std::to_string(kHighestClaimedOrder));
  if (is_tableau(o.integrator)) {
    TableauFile file = parse_tableau_file(o.integrator);
    if (o.order) file.claims.order = Stated<int>{*o.order, {}};
    return audit_tableau(file, limits);
  }
  const Program program = o.program();
  std::optional<OrderDemand> demand;
  if (o.order) demand = OrderDemand{*o.order, &force_class(o.forces)};
  // The catalogue's own files are only looked at.
  return audit_program(program, is_path(o.integrator) ? file_text(program.file) : "", demand, limits);
}

int audit(const AuditOptions& o) {
  AuditLimits limits;
  limits.most_bytes = memory_of(o.memory);
  ProgressLine line;
  limits.progress = line.progress();
  const Audit found = of_file(o, limits);
  write_output(
      o.json ? as_json(found).dump(2) + "\n" : as_text(found, o.ascii ? Style::language : Style::unicode),
      o.output);
  return found.refuted() ? kRefuted : found.undecided() ? kNotDerivable : kDone;
}

}  // namespace

void add_audit(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Prove", "audit",
      "Are the claims of a tableau or an .integrator file true, and what is probably mistyped?",
      {"audit my-tableau.json", "audit suspicious.integrator --order 4", "audit my-tableau.json --json"});
  auto o = std::make_shared<AuditOptions>();
  command->add_option("FILE", o->integrator, "a tableau (.json, docs/tableau.md) or an .integrator file")
      ->required();
  command
      ->add_option("--order", o->order,
                   "the order that the method is said to have; a tableau file may say so itself")
      ->type_name("P");
  command
      ->add_option("--force", o->forces,
                   "with --order: what the forces may read for which it is said: a(x, t) when left out")
      ->type_name("CLASS");
  add_memory(*command, o->memory);
  add_json(*command, *o);
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o, &code] { code = audit(*o); });
}

}  // namespace shortfall::cli
