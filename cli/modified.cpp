// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/program/transform.hpp"
#include "analysis/series/hamiltonian.hpp"
#include "analysis/series/modified.hpp"
#include "cli/command.hpp"
#include "cli/memory.hpp"
#include "cli/output.hpp"
#include "notebooks-export/modified_text.hpp"
#include "notebooks-export/series_json.hpp"

namespace shortfall::cli {

namespace {

struct ModifiedOptions : Question {
  std::string forces;
  int order = 4;
  bool modifying = false;
  bool hamiltonian = false;
  std::string memory = "500MB";
};

/// Not y' = f(y): the class that was asked for, or a(x) where nothing was and the step needs a second-order
/// equation.
const ForceClass* forces_of(const ModifiedOptions& o, const SeriesSource& source) {
  if (!o.forces.empty()) return &force_class(o.forces);
  return source.has_tableau() && !o.hamiltonian ? nullptr : &force_class("position_only");
}

int modified(const ModifiedOptions& o) {
  if (o.order < 1 || o.order > 100) throw BadInput("--order takes a whole number from 1 to 100");
  if (o.modifying && o.hamiltonian)
    throw BadInput("--hamiltonian belongs to the modified equation, not to --modifying");
  const Program program = o.substeps() > 1 ? substepped(o.program(), o.substeps()) : o.program();
  const SeriesSource source(program, o.values());
  const ForceClass* forces = forces_of(o, source);
  if (o.hamiltonian && forces->key != "position_only")
    throw BadInput("a Hamiltonian is looked for with forces a(x): leave --force out");
  OrderLimits limits;
  limits.most_bytes = memory_of(o.memory);
  const ModifiedEquation m = o.modifying ? modifying_equation(source, forces, o.order, limits)
                                         : modified_equation(source, forces, o.order, limits);
  const Style style = o.latex ? Style::latex : o.ascii ? Style::language : Style::unicode;
  std::optional<ModifiedHamiltonian> energy;
  if (o.hamiltonian) energy = modified_hamiltonian(source, o.order, limits);
  if (o.json) {
    auto json = as_json(m, source);
    if (energy) json["hamiltonian"] = as_json(*energy, source);
    write_output(json.dump(2) + "\n", o.output);
  } else {
    std::string text = as_text(m, source, style);
    if (energy) text += as_text(*energy, source, style);
    write_output(text, o.output);
  }
  const bool none = !m.obstruction.empty() || (energy && !energy->exists());
  return none ? kNotDerivable : kDone;
}

}  // namespace

void add_modified(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Prove", "modified",
      "The equation that a step really solves, for every smooth force; its Hamiltonian; and what the step "
      "has to be given instead.",
      {"modified symplectic-euler --order 4 --hamiltonian", "modified midpoint --order 9 --modifying",
       "modified velocity-verlet --force \"a(x, t)\" --json"});
  auto o = std::make_shared<ModifiedOptions>();
  add_integrator(*command, *o);
  command
      ->add_option("--force", o->forces,
                   "what the force may read: general or a(x, v, t), a(x, t), a(x, v), a(x); without it y' = "
                   "f(y) for a "
                   "tableau and a(x) for other steps")
      ->type_name("CLASS");
  command->add_option("--order", o->order, "terms up to h^(N-1), trees of up to N nodes (default 4)")
      ->type_name("N");
  command->add_flag("--modifying", o->modifying,
                    "what to give the step so that it solves the right equation");
  command->add_flag("--hamiltonian", o->hamiltonian, "the energy that it conserves, when there is one");
  add_memory(*command, o->memory);
  add_parameters(*command, *o);
  add_json(*command, *o);
  command->add_flag("--latex", o->latex, "as LaTeX formulas");
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o, &code] { code = modified(*o); });
}

}  // namespace shortfall::cli
