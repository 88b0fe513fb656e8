// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "analysis/program/program.hpp"
#include "analysis/program/source.hpp"

namespace shortfall {

/// What is known of the names at a point of a program.
struct Names {
  struct Entry {
    Type type;
    bool assigned = true;
  };
  std::map<std::string, Entry> known;
  std::set<std::string> later;   ///< locals that the same block assigns somewhere, for a better message
  bool force = true;             ///< whether a(x, v, t) may be called
  bool symbolic_powers = false;  ///< whether an exponent may be a name, as in r^n

  void declare(const std::string& name, Type type, bool assigned = true) { known[name] = {type, assigned}; }
};

/// The type of an expression.
///
/// throws  SyntaxError  at an unknown or unassigned name, or where sorts or dimensions disagree
Type type_of(const Expr& e, const Names& names, const Source& source);

/// Checks a whole program: every name assigned before use, every sort and dimension right.
///
/// throws  SyntaxError
void check(const Program& program, const Source& source);

/// The names that a formula about n steps may use: x0, v0, h, t, n, the force's letters and the parameters.
///
/// param   degree  of the force polynomial f0 + f1 t + ... + fD t^D; 0 also calls it `a`
Names formula_names(const Program& program, int degree);

}  // namespace shortfall
