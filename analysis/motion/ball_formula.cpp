// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/ball_formula.hpp"

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

Ball called(const std::string& function, const Ball& x) {
  if (function == "sqrt") return sqrt(x);
  if (function == "exp") return exp(x);
  if (function == "log") return log(x);
  if (function == "cos") return cos(x);
  if (function == "sin") return sin(x);
  if (function == "cosh") return cosh(x);
  if (function == "sinh") return sinh(x);
  throw Error("'" + function + "' is not computed in balls");
}

}  // namespace

Ball ball_value(const Expr& e, const std::map<std::string, Ball>& values, int bits) {
  using Op = Expression::Op;
  const auto operand = [&](std::size_t i) { return ball_value(e->operands[i], values, bits); };
  switch (e->op) {
    case Op::number:
      return Ball(e->value, bits);
    case Op::name: {
      const auto found = values.find(e->name);
      if (found == values.end()) throw Error("'" + e->name + "' has no value");
      return found->second;
    }
    case Op::negate:
      return -operand(0);
    case Op::add:
      return operand(0) + operand(1);
    case Op::subtract:
      return operand(0) - operand(1);
    case Op::multiply:
      return operand(0) * operand(1);
    case Op::divide:
      return operand(0) / operand(1);
    case Op::power: {
      const Expr& exponent = e->operands[1];
      std::int64_t n = 0;
      if (exponent->op != Op::number || !exponent->value.fits_int64(n) || n < -1'000'000 || n > 1'000'000)
        throw Error("only whole powers are computed in balls");
      return pow(operand(0), static_cast<int>(n));
    }
    case Op::call:
      if (e->name == "pow" && e->operands.size() == 2) return exp(operand(1) * log(operand(0)));
      if (e->operands.size() == 1) return called(e->name, operand(0));
      break;
    default:
      break;
  }
  throw Error("this formula is not computed in balls");
}

}  // namespace shortfall
