// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"
#include "notebooks-export/python_expression.hpp"

namespace shortfall {

/// Where the functions of a step are to live.
enum class PythonUse {
  derivation,  ///< among the cells of a derivation: their names are taken, and nothing may be rounded
  alone,       ///< anywhere: functions that are not rational, such as pow, may be called
};

/// An integrator as Python functions start, step and finish that compute exactly, with fractions.Fraction.
///
///   def step(x, v, STATES, t, h, a, PARAMETERS): ... return x, v, STATES
///
/// `a` is a function of x, v, t. PARAMETERS are those that are free; the others are computed from them, or
/// fixed, where they are needed.
class PythonStep {
 public:
  /// param   substeps  how many steps of h / substeps the function `step` takes
  /// throws  BadInput  for a value of an unknown parameter
  PythonStep(const Program& program, const Values& given, int substeps,
             PythonUse use = PythonUse::derivation);
  PythonStep(const PythonStep&) = delete;
  PythonStep& operator=(const PythonStep&) = delete;

  /// What a name of the program is called in Python: never a keyword or a name that the notebook needs.
  std::string name(const std::string& name) const;

  /// Names of the carried vectors: x, v, then the program's own.
  const std::vector<std::string>& carried() const { return carried_; }
  /// The free parameters that occur, and what each is by default.
  const std::vector<std::pair<std::string, Rational>>& parameters() const { return parameters_; }
  bool has_start() const { return !program_.start.empty(); }
  bool has_finish() const { return !program_.finish.empty(); }

  /// `solved`, where a stage is implicit; empty otherwise.
  std::string solver() const;
  /// The definitions of start, step and finish, as far as they exist.
  std::string functions() const;

  /// "x, v, a0": the carried vectors in Python.
  std::string state() const;
  /// ", beta, gamma": what follows the usual arguments.
  std::string more() const;

 private:
  bool has_solve() const;
  std::string function(const std::string& name, const std::string& what, const std::vector<Statement>& body,
                       const std::string& result) const;
  void write(const std::vector<Statement>& body, int indent, int depth, std::string& text) const;
  void write_solve(const Statement& solve, int indent, std::string& text) const;
  void write_substeps(const Statement& loop, bool last, int indent, int depth, std::string& text) const;
  std::string assignment(int indent, const std::string& target, const Expr& value) const;
  std::string parameter_lines(const std::vector<Statement>& body) const;
  void name_everything();
  /// param  local  whether it lives in start, step and finish only
  void add_name(const std::string& name, bool local);

  Program program_;
  Values values_;
  int substeps_;
  PythonUse use_;
  std::map<std::string, Rational> fixed_;
  std::vector<std::string> derived_;
  std::vector<std::pair<std::string, Rational>> parameters_;
  std::vector<std::string> carried_;
  std::map<std::string, std::string> names_;
  PythonWording wording_;
};

}  // namespace shortfall
