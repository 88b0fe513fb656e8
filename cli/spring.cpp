// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/spring_report.hpp"
#include "analysis/program/catalogue.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/spring_text.hpp"

namespace shortfall::cli {

namespace {

struct SpringOptions : Question {
  std::string frequency;
  std::optional<std::string> ratio;
  std::string k;
  std::string c;
  bool held = false;
};

SpringQuestion question(const SpringOptions& o) {
  SpringQuestion q;
  q.h = o.step();
  q.substeps = o.substeps();
  q.held = o.held;
  q.parameters = o.values();
  if (o.held && o.substeps() < 2)
    throw BadInput("--held: a force is held over substeps; give --substeps 4, for example");
  if (o.k.empty() == o.frequency.empty())
    throw BadInput(
        "give a spring by --frequency 2Hz (and --damping-ratio), or by --k 40 (and --c), not both");
  if (o.k.empty()) {
    if (!o.c.empty()) throw BadInput("--c goes with --k; with --frequency it is --damping-ratio");
    // A length of time as elsewhere: 2Hz is a period of 1/2 s.
    const bool hertz = o.frequency.ends_with("Hz");
    const Rational period =
        positive_quantity(hertz ? o.frequency : o.frequency + "Hz", Unit::time, "--frequency");
    const std::string given = o.ratio.value_or("0");
    const Rational ratio = quantity(given, Unit::none, "--damping-ratio");
    if (ratio.sign() < 0) throw BadInput("--damping-ratio " + given.substr(0, 40) + ": 0 or more");
    set_spring(q, Rational(1) / period, ratio);
  } else {
    if (o.ratio) throw BadInput("--damping-ratio goes with --frequency; with --k it is --c");
    q.k = quantity(o.k, Unit::none, "--k");
    if (q.k.sign() <= 0)
      throw BadInput(
          "--k '" + o.k.substr(0, 60) + "': " +
          (q.k.is_zero()
               ? "without stiffness there is no spring; what damping alone does tells: shortfall damping"
               : "a stiffness below 0 is no spring but unstable physics, which runs away; its motion tells: "
                 "shortfall derive --force spring:k=" +
                     q.k.str()));
    if (!o.c.empty()) q.c = quantity(o.c, Unit::none, "--c");
  }
  return q;
}

void spring(const SpringOptions& o) {
  const SpringQuestion q = question(o);
  SpringQuestion plain = q;
  plain.held = false;
  plain.parameters.clear();
  const SpringReport r = spring_report(o.program(), q);
  const SpringReport native = spring_report(find_integrator("implicit-euler"), plain);
  write_output(o.json ? as_json(r, native).dump(2) + "\n"
                      : as_text(r, native, o.ascii ? Style::language : Style::unicode),
               o.output);
}

}  // namespace

void add_spring(CLI::App& app, int&) {
  CLI::App* command = new_command(app, "Engines", "spring",
                                  "What a spring really is at a tick rate: frequency, damping ratio, "
                                  "stability; and what to give instead.",
                                  {"spring symplectic-euler --frequency 2Hz --damping-ratio 0 --dt 60Hz",
                                   "spring rapier --k 40 --c 1 --dt 60Hz",
                                   "spring symplectic-euler --frequency 2Hz --dt 60Hz --substeps 4 --held"});
  auto o = std::make_shared<SpringOptions>();
  add_integrator(*command, *o);
  command->add_option("--frequency", o->frequency, "of the undamped spring: 2Hz")->type_name("F");
  command->add_option("--damping-ratio", o->ratio, "with --frequency; 1 is critical, 0 the default")
      ->type_name("Z");
  command->add_option("--k", o->k, "instead of --frequency: stiffness for each unit of mass, 1/s^2")
      ->type_name("K");
  command->add_option("--c", o->c, "with --k: damping for each unit of mass, 1/s")->type_name("C");
  command->add_flag("--held", o->held, "the force is computed once a frame and held over the substeps");
  add_parameters(*command, *o);
  add_time_step(*command, *o);
  add_json(*command, *o);
  add_ascii(*command, *o);
  add_output(*command, *o);
  command->callback([o] { spring(*o); });
}

}  // namespace shortfall::cli
