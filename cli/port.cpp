// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/port.hpp"
#include "analysis/program/catalogue.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "notebooks-export/code.hpp"

namespace shortfall::cli {

namespace {

struct PortWords : Question {
  std::string to, to_dt, height, launch, spring, language;
  std::optional<int> to_substeps;
};

/// The damping goes into the question, everything else stays with the engine.
PortQuestion question(const PortWords& o, const Program& from, const Program& to) {
  PortQuestion q;
  Values values = o.values();
  if (const auto c = values.find("c"); c != values.end()) {
    q.c = c->second.to_double();
    values.erase(c);
  }
  q.from = candidate(from, o.substep_count, values);
  q.to = candidate(to, o.to_substeps);
  q.from_dt = o.step();
  q.to_dt = o.to_dt.empty() ? q.from_dt : positive_quantity(o.to_dt, Unit::time, "--to-dt");
  q.g = o.gravity().to_double();
  if (!o.spring.empty()) q.k = positive_quantity(o.spring, Unit::none, "--spring").to_double();
  if (o.height.empty() == o.launch.empty())
    throw BadInput("give the jump by --height 1.7 or by --launch 5, not both");
  q.launch = o.launch.empty()
                 ? std::sqrt(2 * q.g * positive_quantity(o.height, Unit::length, "--height").to_double())
                 : positive_quantity(o.launch, Unit::none, "--launch").to_double();
  return q;
}

std::string digits(double value) { return fmt::format("{:.10g}", std::fabs(value) < 1e-12 ? 0.0 : value); }

std::string port_code(const PortQuestion& q, const Port& p, Language language) {
  std::string text;
  const auto put = [&](const std::string& name, const std::string& about, double value) {
    text += code(CodeFunction{name, {about}, {}, number(Rational::parse(digits(value)))}, language) + "\n";
  };
  put("ported_launch", "The launch velocity in " + q.to.str() + ", m/s.", p.fit.v0[1].value);
  if (q.c != 0) put("ported_damping", "The damping number for " + q.to.str() + ".", p.fit.c.value);
  if (q.k != 0) put("ported_stiffness", "The spring constant over the mass, 1/s^2.", p.fit.k.value);
  put("ported_held_acceleration", "To be held besides gravity, m/s^2; times the mass as a force.", p.held);
  return text;
}

void port_motion(const PortWords& o) {
  std::optional<Language> language;
  if (!o.language.empty()) language = language_of(o.language);
  const Program from = o.program(), to = find_integrator(o.to);
  const PortQuestion q = question(o, from, to);
  const Port p = port(q);
  if (language) return write_output(port_code(q, p, *language), o.output);
  if (o.json) {
    nlohmann::ordered_json r = {{"schema", "shortfall.port/1"},
                                {"from", q.from.str()},
                                {"to", q.to.str()},
                                {"from_dt", q.from_dt.str()},
                                {"to_dt", q.to_dt.str()},
                                {"launch", q.launch},
                                {"ported",
                                 {{"launch", p.fit.v0[1].value},
                                  {"start", p.fit.x0[1].value},
                                  {"c", p.fit.c.value},
                                  {"k", p.fit.k.value},
                                  {"held", p.held}}},
                                {"exact", p.exact},
                                {"error", p.error},
                                {"frames", p.frames}};
    return write_output(r.dump(2) + "\n", o.output);
  }
  std::string text = fmt::format("{} at dt = {} s  ->  {} at dt = {} s\n\n", q.from.str(), q.from_dt.str(),
                                 q.to.str(), q.to_dt.str());
  text += fmt::format("{:<24} {:>16} {:>16}\n", "", "from", "to");
  const auto line = [&](const char* name, double a, double b) {
    text += fmt::format("{:<24} {:>16} {:>16}\n", name, digits(a), digits(b));
  };
  line("launch, m/s", q.launch, p.fit.v0[1].value);
  if (std::fabs(p.fit.x0[1].value) > 1e-12) line("start, m", 0, p.fit.x0[1].value);
  if (q.c != 0) line("damping number c", q.c, p.fit.c.value);
  if (q.k != 0) line("spring k, 1/s^2", q.k, p.fit.k.value);
  line("held acceleration, m/s^2", 0, p.held);
  text +=
      p.exact
          ? fmt::format(
                "\nExact: the same place at all {} common frames of {:.3g} s, up to rounding ({:.1g} m).\n",
                p.frames, p.duration, p.error)
          : fmt::format(
                "\nNot exact: the least squares over {} common frames of {:.3g} s; the largest difference is "
                "{:.3g} m.\n",
                p.frames, p.duration, p.error);
  write_output(text, o.output);
}

}  // namespace

void add_port(CLI::App& app, int&) {
  CLI::App* command = new_command(
      app, "Engines", "port", "Carries a tuned motion to another engine, tick rate or number of substeps.",
      {"port physx rapier --dt 60Hz --height 1.7 --param c=0.5",
       "port jolt jolt --dt 60Hz --to-dt 120Hz --height 1.7 --param c=0.05"});
  auto o = std::make_shared<PortWords>();
  command->add_option("FROM", o->integrator, "where the motion was tuned")->required();
  command->add_option("TO", o->to, "where it is to go")->required();
  command->add_option("--height", o->height, "the jump was launched with sqrt(2 g H)")->type_name("H");
  command->add_option("--launch", o->launch, "or with this velocity, m/s")->type_name("V");
  command->add_option("--spring", o->spring, "a spring to the origin, k over the mass, 1/s^2")
      ->type_name("K");
  command->add_option("--to-dt", o->to_dt, "the time step there; the same unless given")->type_name("DT");
  command->add_option("--to-substeps", o->to_substeps, "the number of substeps there")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command
      ->add_option("--lang", o->language,
                   "code with the numbers: csharp, cpp, gdscript, python, rust, javascript")
      ->type_name("L");
  add_parameters(*command, *o);
  add_time_step(*command, *o);
  add_gravity(*command, *o);
  add_json(*command, *o);
  add_output(*command, *o);
  command->callback([o] { port_motion(*o); });
}

}  // namespace shortfall::cli
