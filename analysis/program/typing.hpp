// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "analysis/program/dimension.hpp"
#include "analysis/program/expression.hpp"
#include "analysis/program/function.hpp"
#include "analysis/program/source.hpp"

namespace shortfall {

/// What is known of an expression.
struct Judgement {
  Type type;
  std::optional<Rational> value;  ///< when it is made of numbers (and of names with a value) only
  int growth = 1;                 ///< a bound on the powers that it multiplies up to
};

/// What is known of the names at a point of a program.
struct Names {
  struct Entry {
    Type type;
    bool assigned = true;
    int growth = 1;
    std::optional<Rational> value = {};
  };
  std::map<std::string, Entry> known;
  std::set<std::string> later;  ///< locals that the same block assigns somewhere, for a better message
  std::map<std::string, std::string> hints;  ///< what to say of a name that is unknown here
  std::string allowed;  ///< what a name may be here, said of one that is not: "; a default may use ..."
  bool force = true;    ///< whether a(x, v, t) may be called
  Functions functions = Functions::none;
  bool log_is_rate = true;       ///< log(2), said of a damping, is one per second; else it is a pure number
  bool symbolic_powers = false;  ///< whether an exponent may be a name, as in r^n

  void declare(const std::string& name, Type type, bool assigned = true) { known[name] = {type, assigned}; }
};

/// Judges an expression.
///
/// throws  SyntaxError  at an unknown or unassigned name, where sorts or dimensions disagree, and where a
/// number
///                      made of numbers divides by zero or has more than 10,000 digits
Judgement judged(const Expr& e, const Names& names, const Source& source);

/// The type of an expression, judged.
Type type_of(const Expr& e, const Names& names, const Source& source);

}  // namespace shortfall
