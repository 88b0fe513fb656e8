// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/transform.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

/// `start` and `finish` belong to the short step as well: their h is h / count.
void shorten(std::vector<Statement>& block, const Expr& shorter) {
  for (Statement& s : block) {
    if (s.value) s.value = replace(s.value, "h", shorter);
    for (Unknown& u : s.unknowns) u.value = replace(u.value, "h", shorter);
    shorten(s.body, shorter);
  }
}

bool is_zero(const Expr& e) { return is_number(e, 0); }

/// The expression with a vector replaced by 0, and tidied where that leaves something to tidy.
Expr without(const Expr& e, const std::string& vector) {
  if (!mentions(e, vector)) return e;
  if (e->op == Expression::Op::name) return number(0);
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = without(operand, vector);
  const auto& o = copy->operands;
  switch (e->op) {
    case Expression::Op::negate:
      return is_zero(o[0]) ? number(0) : Expr(copy);
    case Expression::Op::add:
      return is_zero(o[0]) ? o[1] : is_zero(o[1]) ? o[0] : Expr(copy);
    case Expression::Op::subtract:
      return is_zero(o[1]) ? o[0] : is_zero(o[0]) ? negate(o[1]) : Expr(copy);
    case Expression::Op::multiply:
      return is_zero(o[0]) || is_zero(o[1]) ? number(0) : Expr(copy);
    case Expression::Op::divide:
      return is_zero(o[0]) ? number(0) : Expr(copy);
    default:
      return copy;
  }
}

Expr with_held_force(const Expr& e, const Expr& held) {
  if (e->op == Expression::Op::force) return held;
  if (e->operands.empty()) return e;
  auto copy = std::make_shared<Expression>(*e);
  for (Expr& operand : copy->operands) operand = with_held_force(operand, held);
  return copy;
}

/// So many significant digits of an algebraic number.
Rational digits_of(const RealRoot& root, int digits) {
  return root.is_rational() ? root.rational() : Rational::parse(root.decimal(root.places(digits)));
}

/// Every expression changed.
template <class Change>
std::vector<Statement> changed(std::vector<Statement> block, const Change& change) {
  for (Statement& s : block) {
    if (s.value) s.value = change(s.value);
    for (Unknown& u : s.unknowns) u.value = change(u.value);
    s.body = changed(std::move(s.body), change);
  }
  return block;
}

template <class Change>
std::vector<Statement> calm(const std::vector<Statement>& block, const Change& change) {
  std::vector<Statement> result;
  for (const Statement& s : block) {
    if (s.kind == Statement::Kind::limit_speed || s.kind == Statement::Kind::limit_move) continue;
    if (s.kind == Statement::Kind::when) {
      const std::vector<Statement> body = calm(s.body, change);
      result.insert(result.end(), body.begin(), body.end());
      continue;
    }
    Statement copy = s;
    if (copy.value) copy.value = change(copy.value);
    for (Unknown& u : copy.unknowns) u.value = change(u.value);
    copy.body = calm(s.body, change);
    result.push_back(std::move(copy));
  }
  return result;
}

/// A name that the program does not use.
std::string free_name(const Program& program, std::string wanted) {
  const std::string text = print(program);
  while (text.find(wanted) != std::string::npos) wanted += "_";
  return wanted;
}

}  // namespace

Program undisturbed(const Program& program) {
  Program result = program;
  const std::string held = program.holds_force ? free_name(program, "held") : "";
  result.step = calm(program.step, [&](const Expr& e) {
    const Expr quiet = program.impulse ? without(e, program.impulse->name) : e;
    return program.holds_force ? with_held_force(quiet, name(held)) : quiet;
  });
  if (program.holds_force) {
    Statement first;
    first.name = held;
    first.value = force(name("x"), name("v"), name("t"));
    result.step.insert(result.step.begin(), first);
  }
  result.impulse.reset();
  result.holds_force = false;
  return result;
}

Program with_numbers(const Program& program, int digits) {
  Program result = program;
  const auto numbers = [&](std::vector<Statement>& block) {
    block = changed(block, [&](Expr e) {
      for (const Root& r : program.roots) e = replace(e, r.name, number(digits_of(*r.value, digits)));
      for (const Approximation& a : program.approximations) e = replace(e, a.name, number(a.value));
      return e;
    });
  };
  numbers(result.start);
  numbers(result.step);
  numbers(result.finish);
  result.roots.clear();
  result.approximations.clear();
  result.tableau.reset();
  result.splitting.reset();
  return result;
}

Program substepped(const Program& program, int count) {
  if (count < 1 || count > 10'000)
    throw BadInput("a number of substeps is a whole number from 1 to 10000, not " + std::to_string(count));
  Program result = program;
  if (count == 1) return result;
  const Expr shorter = binary(Expression::Op::divide, name("h"), number(count));
  shorten(result.start, shorter);
  shorten(result.finish, shorter);
  Statement substeps;
  substeps.kind = Statement::Kind::substeps;
  substeps.value = number(count);
  substeps.body = std::move(result.step);
  substeps.whole_steps = true;
  result.step = {std::move(substeps)};
  for (Assumption& a : result.assumptions) {
    a.left = replace(a.left, "h", shorter);
    a.right = replace(a.right, "h", shorter);
  }
  result.tableau.reset();
  result.splitting.reset();
  result.claims.clear();  // they were made about the step of the author
  return result;
}

std::optional<std::string> substep_parameter(const Program& program) {
  std::optional<std::string> found;
  for (const Statement& s : program.step) {
    if (s.kind != Statement::Kind::substeps || s.value->op != Expression::Op::name) continue;
    if (found && *found != s.value->name) return std::nullopt;
    found = s.value->name;
  }
  return found;
}

}  // namespace shortfall
