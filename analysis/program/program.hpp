// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/program/dimension.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

struct Parameter {
  std::string name;
  Dimension dimension;
  Expr fallback;  ///< the default, an expression in parameters declared before it
  Place place;
};

/// A vector carried from step to step besides x and v.
struct State {
  std::string name;
  Dimension dimension;
  Place place;
};

/// One unknown of a `solve`: the vector that satisfies name = value.
struct Unknown {
  std::string name;
  Dimension dimension;
  Expr value;
  Place place;
};

struct Statement {
  enum class Kind { assign, solve, substeps };
  Kind kind = Kind::assign;
  std::string name;               ///< assign: what is assigned
  Expr value;                     ///< assign: the value; substeps: how often
  std::vector<Unknown> unknowns;  ///< solve
  std::vector<Statement> body;    ///< substeps
  Place place;
};

/// A Runge-Kutta tableau. Rows of `a` may be shorter than the number of stages (the rest is 0).
struct Tableau {
  std::vector<Expr> c;
  std::vector<std::vector<Expr>> a;
  std::vector<Expr> b;
  std::vector<Expr> embedded;  ///< empty when there is none
  Place place;
};

/// What the author of an integrator claims about it; proved by a test, never believed.
struct Claim {
  std::string word;  ///< "exact", "shortfall", "shortfall-velocity"
  Expr value;
  Place place;
};

/// An integrator, written down once.  What `parse` returns has been checked: sorts, dimensions, every name
/// assigned before use.
struct Program {
  std::string name;
  std::string description;  ///< the comment above `integrator`, lines joined by '\n'
  std::vector<std::string> aliases;
  std::vector<std::string> sources;
  std::vector<Parameter> parameters;
  std::vector<State> states;
  std::vector<Statement> start;
  std::vector<Statement> step;
  std::vector<Statement> finish;
  std::optional<Tableau> tableau;  ///< when present, `step` was lowered from it
  std::vector<Claim> claims;
  std::string file;  ///< where it was read

  const Parameter* parameter(const std::string& name) const;
};

/// The same structure and the same expressions, wherever they were read.
bool same(const Program& a, const Program& b);

}  // namespace shortfall
