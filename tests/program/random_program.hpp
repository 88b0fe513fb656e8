// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>

#include <string>
#include <utility>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall::testing {

/// Random programs whose sorts and dimensions are right by construction and which never divide by a number
/// that is zero.
class RandomProgram {
 public:
  Program program();

  /// The same with kicks and drifts instead of the step.
  Program splitting_program() {
    Program p = program();
    p.start.clear();
    p.states.clear();
    p.step.clear();
    p.finish.clear();
    p.impulse.reset();
    p.holds_force = false;
    scalars_ = {{"p", kPure}, {"q", kPure}};
    Splitting s;
    for (int i = pick(1, 7); i > 0; --i) s.parts.push_back({pick(0, 2) == 0, entry(), {}});
    s.parts.push_back({false, number(1), {}});
    p.splitting = std::move(s);
    return p;
  }

  /// The same with a tableau instead of the step; what it lowers to is left to the reader of its text.
  Program tableau_program() {
    Program p = program();
    p.start.clear();
    p.states.clear();
    p.step.clear();
    p.finish.clear();
    p.impulse.reset();
    p.holds_force = false;
    scalars_ = {{"p", kPure}, {"q", kPure}};
    Tableau t;
    const int stages = pick(1, 5);
    const bool implicit = pick(0, 2);
    for (int i = 0; i < stages; ++i) {
      t.c.push_back(entry());
      t.a.push_back(entries(pick(0, implicit ? stages + 1 : i + 1)));
    }
    t.b = entries(stages);
    if (pick(0, 2)) t.embedded = entries(stages);
    p.tableau = std::move(t);
    return p;
  }

 private:
  using Names = std::vector<std::pair<std::string, Dimension>>;
  using Op = Expression::Op;

  static int pick(int from, int below) { return *rc::gen::inRange(from, below); }

  static Expr literal() {
    static const std::vector<const char*> texts{"1",    "2",  "3",      "0.1",   "0.25",
                                                "1e-3", "12", "0.0625", "1.5e2", "1e-45"};
    return number(Rational::parse(texts[pick(0, static_cast<int>(texts.size()))]));
  }

  /// A name, or powers of h and d multiplied up: never zero.
  Expr factor(Dimension d) {
    std::vector<Expr> factors;
    for (const auto& [base, exponent] : {std::pair{"h", d.time}, std::pair{"d", d.length}}) {
      if (exponent == 0) continue;
      const Expr size = number(std::abs(exponent));
      const Expr letter = name(base);
      factors.push_back(exponent == 1 ? letter
                                      : binary(Op::power, letter, exponent < 0 ? negate(size) : size));
    }
    if (factors.empty()) return pick(0, 3) == 0 ? name("p") : literal();
    Expr result = factors[0];
    if (factors.size() > 1) result = binary(Op::multiply, result, factors[1]);
    return pick(0, 2) == 0 ? binary(Op::multiply, literal(), result) : result;
  }

  Dimension small() { return {pick(-1, 2), pick(-2, 3)}; }

  /// exp, pow and so on: of positive numbers, so that they have values.
  Expr function(Dimension d, int depth) {
    if (d == kPure && pick(0, 2) == 0)
      return pick(0, 2) ? call("exp", {scalar(kPure, 0)})
                        : call("pow", {factor(kPure), pick(0, 2) ? name("h") : factor(kPure)});
    if (pick(0, 3) == 0) return call("sqrt", {factor(d * d)});
    return call(pick(0, 2) ? "max" : "min", {scalar(d, depth), scalar(d, depth)});
  }

  Expr scalar(Dimension d, int depth) {
    if (depth == 0) return factor(d);
    switch (pick(0, 8)) {
      case 7:
        return function(d, depth - 1);
      case 0:
        return binary(Op::add, scalar(d, depth - 1), scalar(d, depth - 1));
      case 1:
        return binary(Op::subtract, scalar(d, depth - 1), scalar(d, depth - 1));
      case 2: {
        const Dimension part = small();
        return binary(Op::multiply, scalar(part, depth - 1), scalar(d / part, depth - 1));
      }
      case 3: {
        const Dimension part = small();
        return binary(Op::divide, scalar(d * part, depth - 1), factor(part));
      }
      case 4:
        return negate(scalar(d, depth - 1));
      case 5:
        if (d.length % 2 == 0 && d.time % 2 == 0)
          return binary(Op::power, scalar({d.length / 2, d.time / 2}, depth - 1), number(2));
        return binary(Op::power, factor(kPure / d), negate(number(1)));
      default:
        return named(scalars_, d, depth);
    }
  }

  Expr named(const Names& names, Dimension d, int depth) {
    for (const auto& [known, dimension] : names)
      if (dimension == d && pick(0, 2) == 0) return name(known);
    return depth == 0 ? factor(d) : scalar(d, depth - 1);
  }

  Expr vector(Dimension d, int depth) {
    if (depth == 0) {
      const auto& [known, dimension] = vectors_[pick(0, static_cast<int>(vectors_.size()))];
      if (dimension == d) return name(known);
      return binary(Op::multiply, factor(d / dimension), name(known));
    }
    switch (pick(0, 8)) {
      case 0:
        return binary(Op::add, vector(d, depth - 1), vector(d, depth - 1));
      case 1:
        return binary(Op::subtract, vector(d, depth - 1), vector(d, depth - 1));
      case 2: {
        const Dimension part = small();
        return binary(Op::multiply, scalar(part, depth - 1), vector(d / part, depth - 1));
      }
      case 3: {
        const Dimension part = small();
        return binary(Op::multiply, vector(d / part, depth - 1), scalar(part, depth - 1));
      }
      case 4: {
        const Dimension part = small();
        return binary(Op::divide, vector(d * part, depth - 1), factor(part));
      }
      case 5:
        return negate(vector(d, depth - 1));
      case 6:
        return binary(Op::add, number(0), vector(d, depth - 1));
      default:
        if (d == kAcceleration)
          return force(vector(kLength, depth - 1), vector(kVelocity, depth - 1), scalar(kTime, depth - 1));
        return vector(d, depth - 1);
    }
  }

  /// Numbers and parameters without dimension.
  Expr entry() {
    switch (pick(0, 5)) {
      case 0:
        return number(0);
      case 1:
        return negate(binary(Op::divide, literal(), literal()));
      case 2:
        return binary(Op::divide, binary(Op::subtract, number(1), name("p")), number(2));
      case 3:
        return binary(Op::multiply, literal(), binary(Op::power, name("q"), number(2)));
      default:
        return binary(Op::divide, literal(), literal());
    }
  }

  std::vector<Expr> entries(int count) {
    std::vector<Expr> row;
    for (int i = 0; i < count; ++i) row.push_back(entry());
    return row;
  }

  Statement assignment(const std::string& to, Expr value) {
    Statement s;
    s.name = to;
    s.value = std::move(value);
    return s;
  }

  Statement solve() {
    Statement s;
    s.kind = Statement::Kind::solve;
    const int count = pick(1, 3);
    for (int i = 0; i < count; ++i) {
      const std::string unknown = "k" + std::to_string(++unknowns_);
      s.unknowns.push_back({unknown, i == 0 ? kAcceleration : kVelocity, nullptr, {}});
      vectors_.emplace_back(unknown, s.unknowns.back().dimension);
    }
    for (Unknown& u : s.unknowns) u.value = vector(u.dimension, 3);
    return s;
  }

  Statement limit() {
    Statement s;
    s.kind = pick(0, 2) ? Statement::Kind::limit_speed : Statement::Kind::limit_move;
    s.value = size(s.kind == Statement::Kind::limit_speed ? kVelocity : kLength);
    return s;
  }

  /// A bare number, or what has the dimension.
  Expr size(Dimension d) { return pick(0, 2) ? literal() : factor(d); }

  /// Names that are made in it are gone after it.
  Statement when() {
    Statement s;
    s.kind = Statement::Kind::when;
    s.value = size(kVelocity);
    const Names vectors = vectors_, scalars = scalars_;
    s.body = statements(pick(1, 3), false);
    vectors_ = vectors;
    scalars_ = scalars;
    return s;
  }

  std::vector<Statement> statements(int count, bool in_step) {
    std::vector<Statement> block;
    for (int i = 0; i < count; ++i) {
      if (in_step && pick(0, 4) == 0) {
        block.push_back(pick(0, 2) ? limit() : when());
        continue;
      }
      // Small numbers are drawn more often: what comes last would hardly be seen.
      const int kind = in_step && pick(0, 8) == 0 ? 7 : pick(0, in_step ? 7 : 6);
      if (kind == 0) {
        const Dimension d = small();
        const std::string local = "s" + std::to_string(++locals_);
        block.push_back(assignment(local, scalar(d, 3)));
        scalars_.emplace_back(local, d);
      } else if (kind == 1) {
        const Dimension d = pick(0, 2) ? kAcceleration : small();
        const std::string local = "u" + std::to_string(++locals_);
        block.push_back(assignment(local, vector(d, 3)));
        vectors_.emplace_back(local, d);
      } else if (kind < 6) {
        const auto [target, d] = carried_[pick(0, static_cast<int>(carried_.size()))];
        block.push_back(assignment(target, vector(d, 3)));
      } else if (kind == 6) {
        block.push_back(solve());
      } else {
        Statement s;
        s.kind = Statement::Kind::substeps;
        s.value = pick(0, 2) ? number(pick(1, 4)) : name("m");
        s.body = statements(pick(1, 3), false);
        block.push_back(std::move(s));
      }
    }
    return block;
  }

  Names carried_, vectors_, scalars_;
  int locals_ = 0, unknowns_ = 0;
};

inline Program RandomProgram::program() {
  Program p;
  p.name = "random";
  p.description = pick(0, 2) ? "" : "A program that nobody wrote.\n\nIts second paragraph.";
  if (pick(0, 2)) p.aliases = {"chance # 1", "luck"};
  if (pick(0, 2)) p.sources = {"Nobody (1900), Nowhere 1/2"};
  p.parameters = {
      {"p", kPure, number(Rational::parse("0.3")), {}},
      {"d", kLength, number(Rational::parse("1.25")), {}},
      {"m", kPure, number(2), {}},
      {"c", kPure / kTime, number(Rational::parse("0.4")), {}},
      {"q", kPure, binary(Op::divide, binary(Op::subtract, number(1), name("p")), number(3)), {}}};
  carried_ = {{"x", kLength}, {"v", kVelocity}};
  if (pick(0, 2)) {
    p.states = {{"r", kLength, {}}, {"w", kAcceleration, {}}};
    vectors_ = carried_;
    p.start = {assignment("r", vector(kLength, 2)), assignment("w", vector(kAcceleration, 2))};
    carried_.insert(carried_.end(), {{"r", kLength}, {"w", kAcceleration}});
  }
  vectors_ = carried_;
  scalars_ = {{"h", kTime}, {"t", kTime}, {"p", kPure}, {"q", kPure}, {"d", kLength}};
  const Names outside = scalars_;
  if (pick(0, 2)) {
    p.impulse = State{"j", kVelocity, {}};
    vectors_.emplace_back("j", kVelocity);
  }
  p.holds_force = pick(0, 3) == 0;
  if (pick(0, 2))
    p.assumptions = {{number(1), binary(Op::multiply, name("c"), name("h")), pick(0, 2) == 0, {}}};
  if (pick(0, 3) == 0)
    p.solves = binary(Op::subtract, force(name("x"), name("v"), name("t")),
                      binary(Op::multiply, name("c"), name("v")));
  p.step = statements(pick(1, 5), true);
  p.step.push_back(assignment("x", vector(kLength, 4)));
  vectors_ = carried_;
  scalars_ = outside;
  if (pick(0, 2)) p.finish = statements(pick(1, 3), false);
  if (pick(0, 2))
    p.claims = {{"exact", number(pick(0, 4)), {}},
                {"shortfall", binary(Op::multiply, name("a"), binary(Op::power, name("h"), number(2))), {}}};
  return p;
}

}  // namespace shortfall::testing
