// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/motion/sequence.hpp"
#include "analysis/motion/step_map.hpp"

namespace shortfall {

/// A vector after n steps as a combination of x0, v0, f0..fD (in this order), each coefficient in closed
/// form.
using Motion = std::vector<Sequence>;

Motion operator-(const Motion& a, const Motion& b);
bool is_zero(const Motion& motion);

/// The part of a motion that lives on eigenvalues which are no rational functions, an oscillation for
/// example: it satisfies the linear recurrence  polynomial[0] r(n) + polynomial[1] r(n+1) + ... + r(n+d) = 0
/// and is given by its first d values.
struct Oscillation {
  using Values = std::vector<std::vector<Fraction>>;  ///< [column][j]: r(j) of the column's letter, j < d
  std::vector<Fraction> polynomial{Fraction(1)};      ///< monic, lowest power first
  Values position;
  Values velocity;

  int order() const { return static_cast<int>(polynomial.size()) - 1; }
  bool is_zero() const { return order() == 0; }
  /// r(n) for one column of `position` or `velocity`.
  Fraction at(const std::vector<Fraction>& first, int n) const;
};

/// Position and velocity after n steps of an integrator under x'' = f0 + ... + fD t^D (- k x - c v).
///
/// The motion is the sum of `position` (or `velocity`), whose bases are rational functions, and of the
/// oscillation.
struct ClosedForm {
  int degree = 0;
  Motion position;
  Motion velocity;
  std::vector<Motion> states;  ///< every carried vector, without its oscillation
  Oscillation oscillation;
  int valid_from =
      0;  ///< the smallest n from which on it holds (a carried state may need a step or two to settle)
  std::vector<std::pair<Fraction, int>> spectrum;  ///< eigenvalues of the step and their multiplicities
};

/// The closed form, by the spectral decomposition of the step's matrix; eigenvalue 1 by Faulhaber's sums,
/// others by geometric ones.
///
/// throws  Unable  when the coefficients of the step depend on t
ClosedForm closed_form(const StepMap& map, const Progress& progress = {});

/// The true motion x(t) and x'(t) at t = n h.
Motion exact_position(int degree);
Motion exact_velocity(int degree);

/// How a closed form was proved.
struct MotionProof {
  bool proved = false;
  int points = 0;      ///< consecutive n at which it was compared with stepping in letters
  int recurrence = 0;  ///< order of the linear recurrence that both sides satisfy
};

/// Compares the closed form with stepping in letters on as many consecutive n as the order of the linear
/// recurrence that both sides satisfy (for polynomials of degree d in n: d + 1 points), which proves it for
/// every n.
MotionProof prove(const StepMap& map, const ClosedForm& form, const Progress& progress = {});

/// The coefficient of one column's letter in the position (or velocity) after n steps, oscillation included.
Fraction motion_at(const ClosedForm& form, bool position, int n, std::size_t column);

}  // namespace shortfall
