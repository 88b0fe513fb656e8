// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// How exact results become formulas: which name counts the steps, and whether n h is gathered into t.
struct Wording {
  std::vector<std::string> letters;  ///< see letters.hpp
  std::string count = "n";
  bool gather_time = false;  ///< write t for n h
};

/// What a letter is called, as an expression: "h", or "sqrt(2)", "exp(-c*h)" for those of extra_letters.hpp.
Expr letter_expression(const std::string& letter);

/// A name that none of the letters has: the one wanted, or that with a number.
std::string unused_name(const std::string& wanted, const std::vector<std::string>& letters);

/// The name of the letter in column c of a Motion: x0, v0, then a (degree 0) or f0, f1, ...
std::string column_name(int column, int degree);

/// A rational function as a formula.
Expr formula(const Fraction& f, const Wording& wording);

/// coefficient * vector, the coefficient's terms written out: 1/2*a*h^2*n^2 + 1/2*a*h^2*n.
Expr formula(const Fraction& coefficient, const Expr& vector, const Wording& wording);

/// total + part, where the terms of part keep their signs: a + (b - c) becomes a + b - c.
Expr joined(const Expr& total, const Expr& part);

/// product * factor without new parentheses: p * (n*(n-1)/2) becomes p*n*(n-1)/2.
Expr chained(const Expr& product, const Expr& factor);

/// A motion as a formula.
Expr formula(const Motion& motion, int degree, const Wording& wording);

}  // namespace shortfall
