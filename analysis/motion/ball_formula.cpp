// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/ball_formula.hpp"

#include "analysis/algebra/error.hpp"
#include "analysis/program/arithmetic.hpp"

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

Ball called(Function f, const Ball& a, const Ball& b) {
  if (f == Function::pow) return exp(b * log(a));
  if (f == Function::max || f == Function::min)
    throw Unable("the function " + std::string(name_of(f)) + " of the step is not computed in balls");
  return called(std::string(name_of(f)), a);
}

Ball value(const Polynomial& p, const std::vector<Ball>& letters, int bits) {
  Ball sum(0, bits);
  for (const auto& term : p.terms()) {
    Ball product(term.coefficient, bits);
    for (Letter letter = 0; letter < kLetters; ++letter)
      if (const int exponent = term.monomial.exponent(letter); exponent > 0)
        product *= pow(letters[letter], exponent);
    sum += product;
  }
  return sum;
}

}  // namespace

std::vector<Ball> letter_balls(const std::vector<ExtraLetters::Extra>& extras, int bits) {
  std::vector<Ball> letters(kLetters, Ball(0, bits));
  for (const ExtraLetters::Extra& e : extras)
    letters[e.letter] =
        e.root ? ball(*e.root, bits)
               : called(e.function, ball_value(e.a, letters, bits), ball_value(e.b, letters, bits));
  return letters;
}

Ball ball_value(const Fraction& f, const std::vector<Ball>& letters, int bits) {
  if (f.is_constant()) return Ball(f.constant(), bits);
  const Ball above = value(f.numerator(), letters, bits);
  return f.is_polynomial() ? above : above / value(f.denominator(), letters, bits);
}

namespace {

/// Of what is no sum, product or quotient.
Ball leaf_value(const Expr& e, const std::map<std::string, Ball>& values, int bits) {
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
    case Op::power: {
      const Expr& exponent = e->operands[1];
      std::int64_t n = 0;
      if (exponent->op != Op::number || !exponent->value.fits_int64(n) || n < -1'000'000 || n > 1'000'000)
        throw Error("only whole powers are computed in balls");
      return pow(operand(0), static_cast<int>(n));
    }
    case Op::call:
      if (e->name == "pow" && e->operands.size() == 2) return called(Function::pow, operand(0), operand(1));
      if (e->operands.size() == 1) return called(e->name, operand(0));
      break;
    default:
      break;
  }
  throw Error("this formula is not computed in balls");
}

}  // namespace

Ball ball_value(const Expr& e, const std::map<std::string, Ball>& values, int bits) {
  return arithmetic<Ball>(e, [&](const Expr& leaf) { return leaf_value(leaf, values, bits); });
}

}  // namespace shortfall
