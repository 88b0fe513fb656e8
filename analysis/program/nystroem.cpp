// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/nystroem.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;

/// sum of weights times k; null when all weights are 0.
Expr combination(const std::vector<Expr>& weights, const std::vector<Expr>& k, Place place) {
  Expr total;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (is_number(weights[j], 0)) continue;
    const Expr term = is_number(weights[j], 1) ? k[j] : binary(Op::multiply, weights[j], k[j], place);
    total = total ? binary(Op::add, total, term, place) : term;
  }
  return total;
}

}  // namespace

void lower_nystroem(Program& program, const NystroemTableau& tableau) {
  const Place place = tableau.place;
  const Expr x = name("x", place), v = name("v", place), t = name("t", place), h = name("h", place);
  const Expr h_squared = binary(Op::power, h, number(2, place), place);
  const auto plus = [&](const Expr& a, const Expr& b) { return binary(Op::add, a, b, place); };
  const auto times = [&](const Expr& a, const Expr& b) { return binary(Op::multiply, a, b, place); };
  std::vector<Expr> k;
  for (std::size_t i = 0; i < tableau.b.size(); ++i) k.push_back(name("k" + std::to_string(i + 1), place));
  const auto stage = [&](std::size_t i) {
    const Expr& c = tableau.c[i];
    const bool at_start = is_number(c, 0);
    const Expr ahead = is_number(c, 1) ? h : times(c, h);
    Expr position = at_start ? x : plus(x, times(ahead, v));
    if (const Expr bend = combination(tableau.a[i], k, place))
      position = plus(position, times(h_squared, bend));
    return force(position, v, at_start ? t : plus(t, ahead), place);
  };
  const std::size_t stages = tableau.b.size();
  for (std::size_t begin = 0, end = 0; begin < stages; begin = end + 1) {
    end = begin;
    bool implicit = false;
    for (std::size_t i = begin; i <= end; ++i)
      for (std::size_t j = i; j < stages; ++j)
        if (!is_number(tableau.a[i][j], 0)) {
          implicit = true;
          end = std::max(end, j);
        }
    Statement solve;
    solve.kind = Statement::Kind::solve;
    solve.place = place;
    for (std::size_t i = begin; i <= end; ++i) {
      if (implicit)
        solve.unknowns.push_back({k[i]->name, kAcceleration, stage(i), place});
      else
        program.step.push_back({Statement::Kind::assign, k[i]->name, stage(i), {}, {}, place});
    }
    if (implicit) program.step.push_back(solve);
  }
  Expr position = plus(x, times(h, v));
  if (const Expr bend = combination(tableau.b_position, k, place))
    position = plus(position, times(h_squared, bend));
  program.step.push_back({Statement::Kind::assign, "x", position, {}, {}, place});
  if (const Expr push = combination(tableau.b, k, place))
    program.step.push_back({Statement::Kind::assign, "v", plus(v, times(h, push)), {}, {}, place});
}

}  // namespace shortfall
