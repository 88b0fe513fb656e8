// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/expression.hpp"

namespace shortfall {

/// The value of an expression in numbers of any kind: sums, products, quotients and signs are those of T.
///
/// param   other  the value of everything else: numbers, names, powers, calls, the force
template <class T, class Other>
T arithmetic(const Expr& e, const Other& other) {
  const auto operand = [&](std::size_t i) { return arithmetic<T>(e->operands[i], other); };
  switch (e->op) {
    case Expression::Op::negate:
      return -operand(0);
    case Expression::Op::add:
      return operand(0) + operand(1);
    case Expression::Op::subtract:
      return operand(0) - operand(1);
    case Expression::Op::multiply:
      return operand(0) * operand(1);
    case Expression::Op::divide:
      return operand(0) / operand(1);
    default:
      return other(e);
  }
}

}  // namespace shortfall
