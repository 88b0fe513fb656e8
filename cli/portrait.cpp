// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/typing.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/picture.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/figure_portrait.hpp"
#include "notebooks-export/portrait_text.hpp"

namespace shortfall::cli {

namespace {

struct PortraitOptions : Question {
  std::string potential = "x^2/2";
  std::vector<std::string> starts;
  int steps = 200;
  int order = 6;
  std::string plot;
};

Expr potential_of(const std::string& text) {
  Names names;
  names.force = false;
  names.functions = Functions::all;
  names.log_is_rate = false;
  names.allowed = "; a potential is written in x alone";
  names.declare("x", Type{});
  return parse_formula(text, "--potential", names, Type{});
}

PortraitQuestion::Start start_of(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw BadInput("--from '" + text.substr(0, 40) + "': a start is a position and a velocity, such as 1,0");
  return {quantity(text.substr(0, comma), Unit::length, "--from"),
          quantity(text.substr(comma + 1), Unit::none, "--from")};
}

void portrait_command(const PortraitOptions& o) {
  check_picture_name(o.plot);
  PortraitQuestion q;
  q.potential = potential_of(o.potential);
  q.h = o.step();
  q.substeps = o.substeps();
  q.parameters = o.values();
  q.steps = o.steps;
  q.order = o.order;
  for (const std::string& text : o.starts) q.starts.push_back(start_of(text));
  if (q.starts.empty()) q.starts = {{1, 0}};
  const Program program = o.program();
  const Portrait result = portrait(program, q);
  if (!o.plot.empty()) write_picture(portrait_figure(result, surfaces_of(result, program)), o.plot);
  write_output(o.json ? as_json(result).dump(2) + "\n" : o.csv ? as_csv(result) : as_text(result), o.output);
}

}  // namespace

void add_portrait(CLI::App& app, int&) {
  CLI::App* command =
      new_command(app, "Prove", "portrait",
                  "Motions in the plane of position and velocity, and what becomes of their energy.",
                  {"portrait symplectic-euler --dt 1/2 --from 1,0 --plot portrait.svg",
                   "portrait velocity-verlet --potential \"1 - cos(x)\" --dt 1/2 --from 1,0 --from 2,0",
                   "portrait explicit-euler --dt 1/10 --steps 100 --csv"});
  auto o = std::make_shared<PortraitOptions>();
  o->dt = "1/2";
  add_integrator(*command, *o);
  command
      ->add_option("--potential", o->potential,
                   "V(x) for mass 1, so that x'' = -V'(x) (default x^2/2, a spring with k = 1)")
      ->type_name("EXPR");
  command
      ->add_option("--from", o->starts, "position and velocity at the start (default 1,0); may be repeated")
      ->type_name("X,V");
  command->add_option("--steps", o->steps, "frames, 1 to 1000000 (default 200)")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
  command->add_option("--order", o->order, "the modified energy is cut before h^N, 1 to 10 (default 6)")
      ->type_name("N")
      ->check(CLI::Range(1, 10));
  add_parameters(*command, *o);
  add_time_step(*command, *o);
  add_json(*command, *o);
  command->add_flag("--csv", o->csv, "every frame of every motion, one a line");
  command->add_option("--plot", o->plot, "draw it (needs gnuplot): a file that ends in .svg, .png or .pdf")
      ->type_name("FILE");
  add_output(*command, *o);
  command->callback([o] { portrait_command(*o); });
}

}  // namespace shortfall::cli
