// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/float_question.hpp"

#include "analysis/algebra/error.hpp"
#include "cli/correct_general.hpp"
#include "cli/quantity.hpp"

namespace shortfall::cli {

void add_float_options(CLI::App& command, FloatOptions& o, const std::string& formats) {
  add_integrator(command, o);
  add_force(command, o);
  command.add_option("--x0", o.x0, "position at the start (1 m when neither it nor --v0 is given)")
      ->type_name("X");
  command.add_option("--v0", o.v0, "velocity at the start in m/s")->type_name("V");
  command.add_option("--formats", o.formats, formats + "; several with commas")
      ->capture_default_str()
      ->type_name("LIST");
  add_time_step(command, o);
  add_gravity(command, o);
  add_parameters(command, o);
  add_json(command, o);
  add_output(command, o);
}

FloatQuestion float_question(const FloatOptions& o) {
  FloatQuestion q;
  q.program = o.program();
  q.parameters = o.values();
  q.substeps = o.substeps();
  if (is_force_class(o.force) || o.force.starts_with("expr:"))
    throw Unable(
        "under the force " + o.force.substr(0, 60) +
        " neither the map nor the motion is known exactly, so there is nothing that floating point can be "
        "held "
        "to. Give the force that it is nearby, linear in x and v (--force spring:k=4, "
        "damped-spring:k=4,c=1/2, drag:a=-9.81,c=1/10); what the method does under every smooth force say "
        "shortfall order and shortfall modified");
  q.force = force_named(o.force);
  if (q.force.degree == 0 && !q.force.push.contains(0)) q.force.push[0] = -o.gravity();
  for (int d = 0; d <= q.force.degree; ++d)
    if (!q.force.push.contains(d)) throw BadInput("the force needs numbers: --force poly:1:f0=1,f1=2");
  o.step();  // says what is wrong with it
  const StoredQuantity dt = stored_quantity(o.dt, Unit::time, "--dt");
  q.h = dt.meant;
  q.kept_h = dt.kept;
  const bool rests = o.x0.empty() && o.v0.empty();
  q.x0 = rests ? Rational(1) : o.x0.empty() ? Rational() : quantity(o.x0, Unit::length, "--x0");
  q.v0 = o.v0.empty() ? Rational() : quantity(o.v0, Unit::none, "--v0");
  return q;
}

}  // namespace shortfall::cli
