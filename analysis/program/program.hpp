// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/real_roots.hpp"
#include "analysis/program/dimension.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

struct Parameter {
  std::string name;
  Dimension dimension;
  Expr fallback;  ///< the default, an expression in parameters declared before it
  Place place;
};

/// An exact algebraic number with a name: the real solution of left = right, of several the one nearest to
/// `near`.
struct Root {
  std::string name;
  Expr left;
  Expr right;
  std::optional<Rational> near;
  Place place;
  std::shared_ptr<const RealRoot> value;
};

/// A coefficient that is known only to the digits printed.
struct Approximation {
  std::string name;
  Rational value;
  std::string text;  ///< the decimal as printed, "-1.1776799841788710"
  Place place;
};

/// left > right, which closed forms may take for granted.
struct Assumption {
  Expr left;
  Expr right;
  bool less = false;  ///< written as left < right
  Place place;

  /// What is positive: left - right, or right - left.
  Expr positive() const;
  std::string str() const;
};

/// A vector carried from step to step besides x and v; or an impulse.
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
  enum class Kind { assign, solve, substeps, limit_speed, limit_move, when };
  Kind kind = Kind::assign;
  std::string name;               ///< assign: what is assigned
  Expr value;                     ///< assign: the value; substeps: how often; limits, when: the limit
  std::vector<Unknown> unknowns;  ///< solve
  std::vector<Statement> body;    ///< substeps, when
  Place place;
  /// substeps: each of them is a step as the author wrote it, so that an impulse acts in the first only
  bool whole_steps = false;
};

/// A Runge-Kutta tableau. Rows of `a` may be shorter than the number of stages (the rest is 0).
struct Tableau {
  std::vector<Expr> c;
  std::vector<std::vector<Expr>> a;
  std::vector<Expr> b;
  std::vector<Expr> embedded;  ///< empty when there is none
  Place place;
};

/// Kicks and drifts, in the order in which they are done.
struct Splitting {
  struct Part {
    bool kick;
    Expr weight;
    Place place;
  };
  std::vector<Part> parts;
  Place place;
};

/// What the author of an integrator claims about it; proved by a test, never believed.
struct Claim {
  std::string word;  ///< "exact", "shortfall", "trace", "order", "symplectic", ...
  Expr value;        ///< null for words that stand alone
  Place place;
  std::string forces{};  ///< of an order: what the force may read, "a(x, t)"; empty for every force

  /// As it is written: "order 4 if a(x, t)".
  std::string str() const;
};

/// An integrator, written down once.  What `parse` returns has been checked: sorts, dimensions, every name
/// assigned before use.
struct Program {
  static constexpr std::size_t kLongestName = 80;  ///< characters

  std::string name;
  std::string description;  ///< the comment above `integrator`, lines joined by '\n'
  std::vector<std::string> aliases;
  std::vector<std::string> sources;
  std::vector<Parameter> parameters;
  std::vector<Root> roots;
  std::vector<Approximation> approximations;
  std::vector<State> states;
  std::optional<State> impulse;  ///< acts in the first step, zero in every other
  bool holds_force = false;      ///< the force is evaluated once a step, at its beginning
  std::vector<Assumption> assumptions;
  Expr solves;  ///< the acceleration that is meant when it is not a(x, v, t); or null
  std::vector<Statement> start;
  std::vector<Statement> step;
  std::vector<Statement> finish;
  std::optional<Tableau> tableau;      ///< when present, `step` was lowered from it
  std::optional<Splitting> splitting;  ///< likewise
  std::vector<Claim> claims;
  std::string file;  ///< where it was read

  const Parameter* parameter(const std::string& name) const;
  /// Whether results are about decimals that stand for other numbers, so that nothing is "proved".
  bool approximate() const { return !approximations.empty(); }
};

/// The same structure and the same expressions, wherever they were read.
bool same(const Program& a, const Program& b);

}  // namespace shortfall
