// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/program.hpp"
#include "analysis/program/source.hpp"
#include "analysis/program/typing.hpp"

namespace shortfall {

/// Checks a whole program: every name assigned before use, every sort and dimension right.
///
/// throws  SyntaxError
void check(const Program& program, const Source& source);

/// The names that a formula about n steps may use: x0, v0, h, t, n, the force's letters and the parameters.
///
/// param   degree  of the force polynomial f0 + f1 t + ... + fD t^D; 0 also calls it `a`
Names formula_names(const Program& program, int degree);

}  // namespace shortfall
