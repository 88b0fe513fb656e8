// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/intended_motion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/error.hpp"
#include "analysis/problems/undisturbed_numbers.hpp"
#include "analysis/program/arithmetic.hpp"
#include "analysis/program/function.hpp"

namespace shortfall {

namespace {

Rational value_of(const Expr& e, const Values& names);

/// Of what is no sum, product or quotient.
Rational leaf_value(const Expr& e, const Values& names) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t k) { return value_of(e->operands[k], names); };
  switch (e->op) {
    case Op::number:
      return e->value;
    case Op::name:
      return names.at(e->name);
    case Op::force:
      return names.at("a");
    case Op::power: {
      std::int64_t exponent = 0;
      if (operand(1).fits_int64(exponent)) return operand(0).pow(static_cast<int>(exponent));
      break;
    }
    case Op::call: {
      const auto function = function_named(e->name);
      if (!function) break;
      const Rational first = operand(0);
      return value_to_100_digits(*function, first, arity(*function) == 2 ? operand(1) : first);
    }
    default:
      break;
  }
  throw Unable("an expression of `solves` has no value");
}

/// An expression's value; a(...) is what "a" stands for.
Rational value_of(const Expr& e, const Values& names) {
  return arithmetic<Rational>(e, [&](const Expr& leaf) { return leaf_value(leaf, names); });
}

/// Working bits: 1 - e^(-s) and its like lose as many digits as s is small, twice.
int bits_for(const Rational& small) {
  const double size = std::abs(small.to_double());
  const double lost = size < 1 && size > 0 ? -std::log2(size) : size > 0 ? 0 : 4000;
  return 480 + 3 * static_cast<int>(lost);
}

/// (1 - e^(-s))/s
Rational faded(const Rational& s) {
  if (s.is_zero()) return 1;
  const Ball x(s, bits_for(s));
  return ((Ball(1, x.bits()) - exp(-x)) / x).midpoint();
}

/// log(1 + s)/s for s = p + q sqrt(d) > 0.
Rational lessened(const Surd& s) {
  const Rational near = s.approximation(200);
  const Ball x(near, bits_for(near));
  return (log(Ball(1, x.bits()) + x) / x).midpoint();
}

}  // namespace

IntendedMotion::IntendedMotion(const Program& program, const Values& parameters) {
  if (!program.solves) return;
  Values names(parameters.begin(), parameters.end());
  const auto meant = [&](int a, int x, int v, int t) {
    names["a"] = a;
    names["x"] = x;
    names["v"] = v;
    names["t"] = t;
    return value_of(program.solves, names);
  };
  // Vectors cannot be multiplied: what is checked at these points holds for every a, x and v.
  drag_ = -meant(0, 0, 1, 0);
  for (int t = 0; t <= 2; ++t)
    if (meant(1, 0, 0, t) != 1 || !meant(0, 1, 0, t).is_zero() || meant(0, 0, 1, t) != -drag_)
      throw Unable(program.name +
                   " solves another equation than gravity with a linear drag; jumps know only that");
  if (drag_.sign() < 0)
    throw Unable("the drag of " + program.name + " is negative, " + drag_.significant(6) +
                 " per second: it drives the body, and its jump has no top that we know");
}

Surd IntendedMotion::height(const Surd& launch, const Rational& g, const Rational& t) const {
  if (!damped()) return launch * Surd(t) - Surd(g * t * t / 2);
  const Rational kept = faded(drag_ * t) * t;
  return launch * Surd(kept) - Surd(g * (t - kept) / drag_);
}

Surd IntendedMotion::time_of_top(const Surd& launch, const Rational& g) const {
  if (!damped()) return launch / Surd(g);
  return launch / Surd(g) * Surd(lessened(launch * Surd(drag_ / g)));
}

Surd IntendedMotion::top(const Surd& launch, const Rational& g) const {
  if (!damped()) return launch * launch / Surd(2 * g);
  return (launch - Surd(g) * time_of_top(launch, g)) / Surd(drag_);
}

}  // namespace shortfall
