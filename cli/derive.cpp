// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/motion/own_equation.hpp"
#include "cli/command.hpp"
#include "cli/derive_numbers.hpp"
#include "cli/force.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "notebooks-export/latex_text.hpp"
#include "notebooks-export/linear_text.hpp"
#include "notebooks-export/result_json.hpp"
#include "notebooks-export/result_text.hpp"

namespace shortfall::cli {

namespace {

constexpr int kHighestWithKit = 30;         // solving for the kit grows with the cube of the degree
constexpr int kHighestWithDerivation = 30;  // nobody reads the lines of a higher one

int derive_linear(const Question& q, const Program& program, const Force& force) {
  const LinearDerivation d = linear_derivation(program, force, q.values(), q.substeps());
  const LinearKit kit = linear_kit(program, force, q.values(), q.substeps());
  if (q.json)
    write_output(as_json(d, kit).dump(2) + "\n", q.output);
  else if (q.latex)
    write_output(as_latex(d, kit, q.full), q.output);
  else
    write_output(as_text(d, kit, q.ascii ? Style::language : Style::unicode, q.full), q.output);
  return d.proved() ? kDone : kBug;
}

int derive(const Question& q) {
  const Force asked = force_named(q.force);
  if (!asked.push.empty() && !asked.nothing)
    throw BadInput(
        "--force '" + q.force.substr(0, 60) +
        "': formulas keep the letters of the force polynomial; a number for them goes with --steps");
  const Program program = q.program();
  const Force force = with_own_equation(asked, program, q.values());
  if (force.linear()) return derive_linear(q, program, asked);
  const int degree = force.degree;
  const bool with_kit = degree <= kHighestWithKit;
  Derivation d;
  CorrectionKit kit;
  {
    ProgressLine line;
    d = derivation(program, degree, q.values(), q.substeps(), degree <= kHighestWithDerivation,
                   line.progress());
    if (line.progress() && with_kit) line.progress()("solving for the corrections", 0, 1);
    if (with_kit) kit = correction_kit(d);
  }
  if (q.json)
    write_output(as_json(d, with_kit ? &kit : nullptr).dump(2) + "\n", q.output);
  else if (q.latex)
    write_output(as_latex(d, with_kit ? &kit : nullptr), q.output);
  else
    write_output(as_text(d, with_kit ? &kit : nullptr, q.ascii ? Style::language : Style::unicode), q.output);
  if (!with_kit)
    say("shortfall: the derivation's lines and the correction kit are given up to degree 30; the closed form "
        "goes up to degree 200");
  return d.proved() ? kDone : kBug;
}

}  // namespace

void add_derive(CLI::App& app, int& code) {
  CLI::App* command = new_command(
      app, "Start here", "derive",
      "The exact motion after n steps, its shortfall, the corrections, with proofs.",
      {"derive symplectic-euler --force constant", "derive my-own.integrator --force poly:3 --latex",
       "derive newmark --force poly:1 --param beta=1/6", "derive velocity-verlet --force spring",
       "derive symplectic-euler --substeps 4 --json",
       "derive velocity-verlet --force spring:k=1 --dt 1/10 --steps 1e18 --x0 1"});
  auto o = std::make_shared<NumbersOptions>();
  auto q = std::make_shared<Question>();
  add_integrator(*command, *q);
  add_force(*command, *q);
  add_parameters(*command, *q);
  add_numbers(*command, *q, *o);
  add_json(*command, *q);
  command->add_flag("--latex", q->latex, "the derivation as LaTeX (amsmath)");
  add_ascii(*command, *q);
  add_full(*command, *q);
  add_output(*command, *q);
  command->callback([q, o, &code] { code = o->wanted() ? derive_numbers(*q, *o) : derive(*q); });
}

}  // namespace shortfall::cli
