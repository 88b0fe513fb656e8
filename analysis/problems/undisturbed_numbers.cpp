// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/problems/undisturbed_numbers.hpp"

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

constexpr int kBits = 480;  // 144 digits, of which a few are lost on the way
constexpr int kDigits = 100;

Ball ball_of(Function f, const Rational& a, const Rational& b) {
  const Ball x(a, kBits);
  switch (f) {
    case Function::sqrt:
      if (a.sign() < 0) break;
      return sqrt(x);
    case Function::exp:
      return exp(x);
    case Function::log:
      if (a.sign() <= 0) break;
      return log(x);
    case Function::pow:
      if (a.sign() <= 0) break;
      return exp(log(x) * Ball(b, kBits));
    default:
      throw Unable("the function " + std::string(name_of(f)) + " does not stand in programs");
  }
  throw Undefined(std::string(name_of(f)) + " of " + a.significant(10) + " is no real number");
}

}  // namespace

Rational value_to_100_digits(Function f, const Rational& a, const Rational& b,
                             std::set<std::string>* rounded) {
  if (f == Function::pow && a.is_zero() && b.sign() > 0) return 0;
  try {
    return value_of(f, a, b);
  } catch (const Unable&) {
    const Ball value = ball_of(f, a, b);
    if (!value.significant(kDigits + 1))
      throw Unable("the value of " + std::string(name_of(f)) + " is not known to " + std::to_string(kDigits) +
                   " digits");
    if (rounded)
      rounded->insert(std::string(name_of(f)) + "(" + a.str() + (arity(f) == 2 ? ", " + b.str() : "") + ")");
    return value.midpoint();
  }
}

}  // namespace shortfall
