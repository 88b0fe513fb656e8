// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/derive_numbers.hpp"

#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/numeric_text.hpp"

namespace shortfall::cli {

namespace {

Rational step_count(const NumbersOptions& o, const Rational& h) {
  if (!o.steps.empty() && !o.until.empty())
    throw BadInput("--steps and --until say the same thing; give one of them");
  if (!o.steps.empty()) {
    Rational n = quantity(o.steps, Unit::none, "--steps");
    if (!n.is_integer() || n.sign() < 0)
      throw BadInput("--steps " + o.steps.substr(0, 40) + ": a number of steps is a whole number, 0 or more");
    return n;
  }
  Rational n = quantity(o.until, Unit::time, "--until") / h;
  if (n.sign() < 0) throw BadInput("--until: the time is 0 or more");
  if (!n.is_integer())
    throw BadInput("--until " + o.until.substr(0, 40) + " lies between two frames; the one before is at " +
                   (n.floor() * h).str() + " s");
  return n;
}

}  // namespace

void add_numbers(CLI::App& command, Question& q, NumbersOptions& o) {
  command
      .add_option("--steps", o.steps,
                  "numbers instead of formulas: where so many steps lead, however many (1e18)")
      ->type_name("N");
  command.add_option("--until", o.until, "the same by time, a whole number of steps: 10, 1e15, 5min")
      ->type_name("TIME");
  command.add_option("--x0", o.x0, "position at the start, with --steps: 1, 40cm")
      ->capture_default_str()
      ->type_name("X");
  command.add_option("--v0", o.v0, "velocity at the start in m/s, with --steps")
      ->capture_default_str()
      ->type_name("V");
  add_time_step(command, q);
  add_gravity(command, q);
}

int derive_numbers(const Question& q, const NumbersOptions& o) {
  if (q.latex)
    throw BadInput("--latex writes formulas; with --steps there are numbers: leave one of the two out");
  NumericQuestion n;
  n.force = force_named(q.force);
  // The constant force is gravity unless it is given.
  if (n.force.degree == 0 && !n.force.push.contains(0)) n.force.push[0] = -q.gravity();
  n.parameters = q.values();
  n.substeps = q.substeps();
  n.h = q.step();
  n.x0 = quantity(o.x0, Unit::length, "--x0");
  n.v0 = quantity(o.v0, Unit::none, "--v0");
  n.steps = step_count(o, n.h);
  const Program program = q.program();
  const NumericMotion m = numeric_motion(program, n);
  write_output(q.json ? as_json(m, n, program.name).dump(2) + "\n"
                      : as_text(m, n, program.name, q.ascii ? Style::language : Style::unicode),
               q.output);
  return kDone;
}

}  // namespace shortfall::cli
