// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// What the scalar names of a formula about n steps stand for.
using FormulaScalars = std::map<std::string, Fraction>;

/// n, h, t = n h and the parameters of an integrator, as symbolic problems see them: a letter, the number
/// that the user gave, or what the default makes of other parameters.
///
/// throws  BadInput  for a value of an unknown parameter
///
/// param   extras  of the step map with which the formula is compared: its roots and functions
FormulaScalars formula_scalars(const Program& program, const Values& given = {},
                               ExtraLetters* extras = nullptr);

/// A formula about n steps under x'' = f0 + f1 t + ... + fD t^D as a combination of x0, v0, f0..fD; `a` is
/// f0.
///
/// Powers r^n of what does not depend on n become the bases of its sequences, so that equality with a closed
/// form decides whether the two are the same function of n. Where n is left in a denominator the formula has
/// no value at some n.
///
/// param   formula  checked against formula_names
/// throws  Undefined  where it divides by zero;  Unable  when it is no combination of this kind
Motion evaluated(const Expr& formula, const FormulaScalars& scalars, int degree,
                 ExtraLetters* extras = nullptr);

/// Where a formula has no value although its motion may have one: n = 0 of v0*t^2/(n*h).
struct FormulaGaps {
  std::vector<Rational> counts;  ///< whole n >= 0 at which it divides by zero, whatever the letters are
  bool of_letters = false;       ///< whether it divides by something that is zero for some letters
};

/// The gaps of a formula that evaluated() takes.
FormulaGaps formula_gaps(const Expr& formula, const FormulaScalars& scalars, int degree,
                         ExtraLetters* extras = nullptr);

/// A formula that contains no vector, as a rational function of its scalars.
///
/// throws  Unable  when it has a power of n, or n in an exponent
Fraction scalar_value(const Expr& formula, const FormulaScalars& scalars, ExtraLetters* extras = nullptr);

}  // namespace shortfall
