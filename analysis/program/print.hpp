// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/program.hpp"

namespace shortfall {

enum class Style {
  language,  ///< the .integrator language, which can be read back: x0 + 1/2*a*t^2
  unicode,   ///< for a terminal: x₀ + ½ a t²
  latex,     ///< x_0 + \frac{1}{2}\,a\,t^2
};

/// An expression as text, with as few parentheses as its structure allows.
std::string print(const Expr& e, Style style = Style::language);

/// An expression of a program in the language: its numbers stay decimals, 0.1 and not 1/10, which may round
/// differently.
std::string print_decimals(const Expr& e);

/// The integrator as a file: parse(print(p)) is the same program.
std::string print(const Program& program);

}  // namespace shortfall
