// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall::cli {

/// What a run of the command ends with; see the table in README.md.
enum ExitCode {
  kDone = 0,
  kRefuted = 1,
  kUsage = 2,
  kBadFile = 3,
  kNotDerivable = 4,
  kInputOutput = 5,
  kBug = 70,
};

/// The options that several commands share, as the user typed them.
struct Question {
  std::string integrator = "symplectic-euler";
  std::string force = "constant";
  std::string dt = "1/50";
  std::string g = "9.81";
  std::optional<int> substep_count;  ///< of --substeps
  std::vector<std::string> parameters;
  bool json = false;
  bool latex = false;
  bool csv = false;
  bool ascii = false;
  bool full = false;  ///< long formulas are written out
  std::string output;

  Program program() const;  ///< throws BadInput, SyntaxError
  /// Of --param; and of --substeps, where the program counts its own substeps with a parameter.
  Values values() const;  ///< throws BadInput, SyntaxError
  /// How many steps of h/N make a frame; 1 where --substeps sets a parameter of the program.
  int substeps() const;      ///< throws BadInput, SyntaxError
  Rational step() const;     ///< dt in seconds; throws BadInput
  Rational gravity() const;  ///< in m/s^2, positive downwards; throws BadInput
};

/// Adds options to a command, with the same words everywhere.
void add_integrator(CLI::App& command, Question& q);
void add_force(CLI::App& command, Question& q);
void add_time_step(CLI::App& command, Question& q);
void add_gravity(CLI::App& command, Question& q);
void add_parameters(CLI::App& command, Question& q);  ///< --param and --substeps
void add_json(CLI::App& command, Question& q);
void add_ascii(CLI::App& command, Question& q);
void add_full(CLI::App& command, Question& q);
void add_output(CLI::App& command, Question& q);

/// Each file of a command has one of these: it declares the command; its callback does the work and returns
/// through `code`.
void add_list(CLI::App& app, int& code);
void add_show(CLI::App& app, int& code);
void add_new(CLI::App& app, int& code);
void add_doctor(CLI::App& app, int& code);
void add_derive(CLI::App& app, int& code);
void add_verify(CLI::App& app, int& code);
void add_correct(CLI::App& app, int& code);
void add_jump(CLI::App& app, int& code);
void add_stability(CLI::App& app, int& code);
void add_order(CLI::App& app, int& code);
void add_modified(CLI::App& app, int& code);
void add_portrait(CLI::App& app, int& code);
void add_audit(CLI::App& app, int& code);
void add_budget(CLI::App& app, int& code);
void add_clock(CLI::App& app, int& code);
void add_cycle(CLI::App& app, int& code);
void add_trade(CLI::App& app, int& code);
void add_advise(CLI::App& app, int& code);
void add_extremes(CLI::App& app, int& code);
void add_damping(CLI::App& app, int& code);
void add_spring(CLI::App& app, int& code);
void add_export(CLI::App& app, int& code);
void add_identify(CLI::App& app, int& code);
void add_port(CLI::App& app, int& code);
void add_guard(CLI::App& app, int& code);
void add_completion(CLI::App& app, int& code);
void add_manual(CLI::App& app, int& code);

/// A new command: its group in the help, examples first.
CLI::App* new_command(CLI::App& app, const std::string& group, const std::string& name,
                      const std::string& what, const std::vector<std::string>& examples);

}  // namespace shortfall::cli
