// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/transform.hpp"
#include "cli/command.hpp"
#include "cli/quantity.hpp"

namespace shortfall::cli {

namespace {

/// Why a text is no number of substeps; empty when it is one. CLI11 would say it differently in each version.
std::string not_a_count(const std::string& text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc{} && stopped == end && value >= 1 && value <= 10'000) return {};
  return "'" + text + "' is not a whole number from 1 to 10000";
}

}  // namespace

Program Question::program() const { return find_integrator(integrator); }

int Question::substeps() const { return substep_count && !substep_parameter(program()) ? *substep_count : 1; }

Values Question::values() const {
  Values values;
  for (const std::string& text : parameters) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw BadInput("--param '" + text + "': write NAME=VALUE, as in --param beta=1/4");
    const std::string name = text.substr(0, equals);
    if (!values.emplace(name, quantity(text.substr(equals + 1), Unit::none, "--param " + name)).second)
      throw BadInput("--param " + name + " is given twice");
  }
  if (substep_count)
    if (const auto own = substep_parameter(program()); own && !values.emplace(*own, *substep_count).second)
      throw BadInput("--substeps is --param " + *own + " here: give one of them");
  return values;
}

Rational Question::step() const { return positive_quantity(dt, Unit::time, "--dt"); }

Rational Question::gravity() const { return positive_quantity(g, Unit::none, "--g"); }

void add_integrator(CLI::App& command, Question& q) {
  command
      .add_option("INTEGRATOR", q.integrator,
                  "a name or an alias (see: shortfall list), an engine with its version (rapier@0.21), or "
                  "the path of "
                  "an .integrator file")
      ->capture_default_str();
}

void add_force(CLI::App& command, Question& q) {
  command
      .add_option("--force", q.force,
                  "constant (a), poly:D (f0 + f1 t + ... + fD t^D), spring (-k x), damped-spring (-k x - c "
                  "v), drag (a - c v), or a sum such as constant+spring; spring:k=4 fixes a letter")
      ->capture_default_str()
      ->type_name("F");
}

void add_time_step(CLI::App& command, Question& q) {
  command.add_option("--dt", q.dt, "the time step: 0.02, 1/50, 20ms, 50Hz; 1/60f rounds to binary32")
      ->capture_default_str()
      ->type_name("DT");
}

void add_gravity(CLI::App& command, Question& q) {
  command.add_option("--g", q.g, "gravity in m/s^2, positive downwards")
      ->capture_default_str()
      ->type_name("G");
}

void add_parameters(CLI::App& command, Question& q) {
  command.add_option("--param", q.parameters, "a parameter of the integrator: NAME=VALUE; may be repeated")
      ->type_name("N=V")
      ->allow_extra_args(false);
  command
      .add_option("--substeps", q.substep_count,
                  "steps of h/N for each frame h, 1 to 10000 (1 unless given); for an integrator that has "
                  "substeps of its own, how many")
      ->type_name("N")
      ->check(not_a_count);
}

void add_json(CLI::App& command, Question& q) { command.add_flag("--json", q.json, "the answer as JSON"); }

void add_ascii(CLI::App& command, Question& q) {
  command.add_flag("--ascii", q.ascii, "plain ASCII formulas, in the .integrator language");
}

void add_full(CLI::App& command, Question& q) {
  command.add_flag("--full", q.full,
                   "under springs, dampers and drag: long formulas written out, instead of named");
}

void add_output(CLI::App& command, Question& q) {
  command.add_option("-o,--output", q.output, "write to this file")->type_name("FILE");
}

namespace {

/// The kinds of output: one command prints one of them.
constexpr std::array<const char*, 4> kKinds{"--json", "--csv", "--latex", "--lang"};

void refuse_two_kinds(const CLI::App& command) {
  const char* first = nullptr;
  for (const char* kind : kKinds) {
    const CLI::Option* option = command.get_option_no_throw(kind);
    if (!option || option->count() == 0) continue;
    if (first) throw BadInput(std::string(first) + " and " + kind + ": give one of them");
    first = kind;
  }
}

}  // namespace

CLI::App* new_command(CLI::App& app, const std::string& group, const std::string& name,
                      const std::string& what, const std::vector<std::string>& examples) {
  CLI::App* command = app.add_subcommand(name, what);
  command->group(group);
  std::string text = "Examples:\n";
  for (const std::string& e : examples) text += "  shortfall " + e + "\n";
  command->footer("");
  command->description(text + "\n" + what);
  if (name != "export")  // it writes as many files as it is asked for
    command->parse_complete_callback([command] { refuse_two_kinds(*command); });
  return command;
}

}  // namespace shortfall::cli
