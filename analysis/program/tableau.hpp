// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/program.hpp"
#include "analysis/program/source.hpp"

namespace shortfall {

/// Reads one row of a tableau block: `c | A ...`, `b | ...` or `embedded | ...`.
///
/// throws  SyntaxError
void read_tableau_row(Tableau& tableau, const Source& source, int& line, std::size_t byte,
                      const std::string& first);

/// Writes the step of a program from its tableau, applied to (x, v) with x' = v, v' = a(x, v, t).
///
/// Stage i is the acceleration k_i; stages that depend on themselves or on later ones are solved for, in the
/// smallest groups.
///
/// source  Hairer, Noersett & Wanner (1993), Solving Ordinary Differential Equations I, II.1, (1.8)
///
/// throws  SyntaxError  when the sizes disagree
void lower_tableau(Program& program, const Source& source);

}  // namespace shortfall
