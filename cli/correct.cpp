// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "analysis/correction/kit.hpp"
#include "cli/command.hpp"
#include "cli/force.hpp"
#include "cli/output.hpp"
#include "notebooks-export/result_json.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall::cli {

namespace {

int correct(const Question& q) {
  const Derivation d = derivation(q.program(), force_degree(q.force), q.values(), q.substeps, false);
  const CorrectionKit kit = correction_kit(d);
  if (q.json) {
    write_output(as_json(kit, d).dump(2) + "\n", q.output);
  } else {
    const Style style = q.ascii ? Style::language : Style::unicode;
    write_output(d.integrator + ": " + line("shortfall x(t)-x_n", d.shortfall_position, style) + "\n" +
                     std::string(d.integrator.size() + 2, ' ') + line("shortfall v(t)-v_n", d.shortfall_velocity, style) + "\n" + as_text(kit, d, style),
                 q.output);
  }
  return kit.needed && !kit.best() ? kNotDerivable : kDone;
}

}  // namespace

void add_correct(CLI::App& app, int& code) {
  CLI::App* command = new_command(app, "Start here", "correct", "The correction kit alone: what to add to launch, read-out, force or step.",
                                  {"correct symplectic-euler --force constant", "correct explicit-euler --force poly:2 --json"});
  auto q = std::make_shared<Question>();
  add_integrator(*command, *q);
  add_force(*command, *q);
  add_parameters(*command, *q);
  add_json(*command, *q);
  add_ascii(*command, *q);
  add_output(*command, *q);
  command->callback([q, &code] { code = correct(*q); });
}

}  // namespace shortfall::cli
