// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Steps of x'' = -y x as matrices, written out: what amplifications are held against.

#include "analysis/algebra/fraction.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall::testing {

inline Fraction y() { return Fraction::letter(kStiffness); }

inline SquareMatrix<Fraction> drift(const Fraction& h) { return {{1, h}, {0, 1}}; }
inline SquareMatrix<Fraction> kick(const Fraction& h) { return {{1, 0}, {-h * y(), 1}}; }

/// Half a drift, a kick, half a drift.
inline SquareMatrix<Fraction> verlet(const Fraction& h) {
  return product(drift(h / Fraction(2)), product(kick(h), drift(h / Fraction(2))));
}

/// The triple jump: c, 1 - 2 c, c times a step; c = 1/(2 - w).
///
/// source  Forest & Ruth (1990), Fourth-order symplectic integration, (4.9); Yoshida (1990), Construction of
/// higher order symplectic integrators
template <class Step>
SquareMatrix<Fraction> triple_jump(const Fraction& h, const Fraction& w, Step&& step) {
  const Fraction c = h / (Fraction(2) - w);
  return product(step(c), product(step(h - Fraction(2) * c), step(c)));
}

}  // namespace shortfall::testing
