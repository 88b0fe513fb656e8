// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// What the letters of a formula are written as.
struct FormulaLetters {
  struct Name {
    Letter letter;
    std::string name;
    int exponent = 1;  ///< the letter is that power of the name: y is z^2
  };
  std::vector<Name> powers;      ///< formulas are sorted by these, lowest powers first, written in this order
  std::vector<Name> parameters;  ///< these belong to the coefficients
};

/// A rational function as people write amplification factors: lowest powers first; a quotient with whole
/// coefficients, both sides in factors.
///
/// param   times  one more factor, if there is one: (1 + 2*n)*x0
Expr letter_formula(const Fraction& f, const FormulaLetters& letters, const Expr& times = nullptr);

}  // namespace shortfall
