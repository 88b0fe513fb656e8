// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/program.hpp"

namespace shortfall {

/// The coefficients of a Nystroem method for x'' = a(x, t).
///
/// shape  a is square, its size that of the other rows
struct NystroemTableau {
  std::vector<std::vector<Expr>> a;
  std::vector<Expr> b_position;
  std::vector<Expr> b;
  std::vector<Expr> c;
  Place place;
};

/// Writes the step of a program from a Nystroem tableau: k_i = a(x + c_i h v + h^2 sum_j a_ij k_j, v, t + c_i
/// h), x = x + h v + h^2 sum_i b_position_i k_i, v = v + h sum_i b_i k_i.
///
/// The force sees the velocity at the beginning of the step: the method is meant for forces that do not look
/// at it. Stages that depend on themselves or on later ones are solved for together.
///
/// source  Hairer, Norsett & Wanner (1993), Solving Ordinary Differential Equations I, II.14, (14.7)
void lower_nystroem(Program& program, const NystroemTableau& tableau);

}  // namespace shortfall
