// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/kit_letters.hpp"

#include "analysis/algebra/rational.hpp"

namespace shortfall {

Expr derivative_name(int j, int degree) {
  if (degree == 0) return name("a");
  return name("f" + std::string(j, '\''));
}

Expr derivative(int j, int degree, bool at_zero) {
  Expr total = number(0);
  for (int d = j; d <= degree; ++d) {
    const Rational weight = factorial(d) / factorial(d - j);
    Expr term = name("f" + std::to_string(d));
    if (!weight.is_one()) term = number(weight) * term;
    if (d > j && at_zero) break;
    if (d > j) term = term * power(name("t"), d - j);
    total = is_number(total, 0) ? term : total + term;
  }
  return total;
}

}  // namespace shortfall
