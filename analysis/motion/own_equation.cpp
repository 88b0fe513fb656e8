// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/motion/own_equation.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/formula.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/problems/linear_form.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

namespace {

using Op = Expression::Op;

constexpr int kForceColumn = 0, kPositionColumn = 1, kVelocityColumn = 2;

/// A scalar has `factor`, a vector `form`; the number 0 is both.
struct EquationValue {
  Fraction factor;
  LinearForm form;
  bool vector = false;
};

class Equation {
 public:
  Equation(const Program& program, const FormulaScalars& scalars, ExtraLetters& extras)
      : program_(program), scalars_(scalars), extras_(extras) {}

  LinearForm of(const Expr& e) const { return value(e).form; }

 private:
  [[noreturn]] void refuse(const Expr& e) const {
    throw Unable("the equation that '" + program_.name +
                 "' solves is read as a(x, v, t) - k*x - c*v; we do "
                 "not take '" +
                 print(e) + "' there");
  }

  EquationValue vector(int column) const { return {{}, LinearForm::column(column), true}; }

  EquationValue value(const Expr& e) const {
    const auto operand = [&](std::size_t i) { return value(e->operands[i]); };
    switch (e->op) {
      case Op::number:
        return {e->value, {}, false};
      case Op::name:
        if (e->name == "x") return vector(kPositionColumn);
        if (e->name == "v") return vector(kVelocityColumn);
        // The step and the time have values here, but an equation of motion knows neither.
        if (const auto found = scalars_.find(e->name);
            found != scalars_.end() && e->name != "h" && e->name != "t" && e->name != "n")
          return {found->second, {}, false};
        break;
      case Op::force:
        if (e->operands[0]->name == "x" && e->operands[1]->name == "v" && e->operands[2]->name == "t")
          return vector(kForceColumn);
        break;
      case Op::negate: {
        const EquationValue v = operand(0);
        return {-v.factor, -v.form, v.vector};
      }
      case Op::add:
      case Op::subtract: {
        EquationValue left = operand(0);
        const EquationValue right = operand(1);
        left.vector = left.vector || right.vector;
        if (e->op == Op::add) return {left.factor + right.factor, left.form + right.form, left.vector};
        return {left.factor - right.factor, left.form - right.form, left.vector};
      }
      case Op::multiply: {
        const EquationValue left = operand(0), right = operand(1);
        if (left.vector) return {{}, right.factor * left.form, true};
        return {left.factor * right.factor, left.factor * right.form, right.vector};
      }
      case Op::divide: {
        const EquationValue left = operand(0), right = operand(1);
        if (right.factor.is_zero())
          throw Undefined("the equation that '" + program_.name + "' solves divides by '" +
                          print(e->operands[1]) + "', which is zero");
        return {left.factor / right.factor, left.form / right.factor, left.vector};
      }
      case Op::power: {
        const Fraction exponent = operand(1).factor;
        std::int64_t whole = 0;
        if (exponent.is_constant() && exponent.constant().fits_int64(whole) && whole >= -1000 &&
            whole <= 1000)
          return {operand(0).factor.pow(static_cast<int>(whole)), {}, false};
        break;
      }
      case Op::call: {
        const Fraction a = operand(0).factor;
        const Fraction b = e->operands.size() > 1 ? operand(1).factor : a;
        return {extras_.function(*function_named(e->name), a, b), {}, false};
      }
      case Op::sum:
        break;
    }
    refuse(e);
  }

  const Program& program_;
  const FormulaScalars& scalars_;
  ExtraLetters& extras_;
};

/// Whether a vector occurs besides in a(x, v, t).
bool mentions_outside(const Expr& e, const std::string& vector) {
  if (e->op == Op::force) return false;
  if (e->op == Op::name) return e->name == vector;
  return std::ranges::any_of(e->operands, [&](const Expr& o) { return mentions_outside(o, vector); });
}

/// One letter of the force, k or c, decided between the user and the integrator.
void decide(const Program& program, const Fraction& own, const char* what, const char* letter,
            const OwnEquation& equation, bool& asked, std::optional<Rational>& number,
            std::optional<Fraction>& coefficient) {
  if (own.is_zero()) return;  // then it is the user's
  if (asked && number) {
    std::string names;
    for (const std::string& p : equation.parameters) names += (names.empty() ? "--param " : ", --param ") + p;
    throw BadInput("'" + program.name + "' has " + what + " of its own: its number is given by " + names +
                   "; leave " + letter + " out of the force");
  }
  asked = true;
  if (own.is_constant()) number = own.constant();
  coefficient = own;
}

}  // namespace

OwnEquation own_equation(const Program& program, const Values& given, ExtraLetters& extras) {
  OwnEquation equation;
  if (!program.solves) return equation;
  const FormulaScalars scalars = formula_scalars(program, given, &extras);
  const LinearForm form = Equation(program, scalars, extras).of(program.solves);
  if (!form[kForceColumn].is_one())
    throw Unable("the equation that '" + program.name + "' solves, x'' = " + print(program.solves) +
                 ", does not have the force a(x, v, t) with weight 1");
  equation.stiffness = -form[kPositionColumn];
  equation.damping = -form[kVelocityColumn];
  for (const Parameter& p : program.parameters)
    if (mentions(program.solves, p.name)) equation.parameters.push_back(p.name);
  return equation;
}

Force with_own_equation(const Force& asked, const Program& program, const Values& given,
                        ExtraLetters& extras) {
  Force force = asked;
  if (!program.solves) return force;
  const OwnEquation own = own_equation(program, given, extras);
  // A vector that stands in `solves` outside of the force is the integrator's own business.
  if (mentions_outside(program.solves, "x"))
    decide(program, own.stiffness, "a spring", "k", own, force.spring, force.k, force.own_k);
  if (mentions_outside(program.solves, "v"))
    decide(program, own.damping, "damping", "c", own, force.damper, force.c, force.own_c);
  force.own_open = std::ranges::any_of(own.parameters, [&](const auto& p) { return !given.contains(p); });
  return force;
}

Force with_own_equation(const Force& asked, const Program& program, const Values& given) {
  if (!program.solves) return asked;
  const NumberField field;
  ExtraLetters extras(letter_names(lower(program, given)));
  return with_own_equation(asked, program, given, extras);
}

Force without_own_equation(Force force) {
  if (force.own_k) {
    force.spring = false;
    force.k.reset();
  }
  if (force.own_c) {
    force.damper = false;
    force.c.reset();
  }
  force.own_k.reset();
  force.own_c.reset();
  return force;
}

std::optional<ExactDecay> exact_decay(const Fraction& damping,
                                      const std::vector<ExtraLetters::Extra>& extras) {
  const Fraction wanted = -damping * Fraction::letter(kStepLetter);
  for (const ExtraLetters::Extra& e : extras) {
    if (e.root) continue;
    Fraction exponent;  // the letter is e to this power
    if (e.function == Function::exp) exponent = e.a;
    if (e.function == Function::pow)
      for (const ExtraLetters::Extra& log : extras)
        if (!log.root && log.function == Function::log && log.a == e.a)
          exponent = e.b * Fraction::letter(log.letter);
    if (exponent.is_zero()) continue;
    const Fraction parts = wanted / exponent;
    std::int64_t whole = 0;
    if (parts.is_constant() && parts.constant().fits_int64(whole) && whole >= 1 && whole <= 10'000)
      return ExactDecay{e.letter, static_cast<int>(whole)};
  }
  return std::nullopt;
}

}  // namespace shortfall
