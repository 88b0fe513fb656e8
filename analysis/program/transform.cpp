// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/transform.hpp"

#include "analysis/algebra/error.hpp"

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

}  // namespace

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
  result.step = {std::move(substeps)};
  result.tableau.reset();
  result.claims.clear();  // they were made about the step of the author
  return result;
}

}  // namespace shortfall
