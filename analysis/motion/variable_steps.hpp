// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// Steps h_1, ..., h_n of any lengths under a constant acceleration a, where one step is
///   x += drift h v + alpha a h^2,   v += kick a h
/// with numbers drift, kick, alpha, and start and finish shift by multiples of a h_1 and a h_n. With t the
/// sum of the h_k and S the sum of their squares, after n steps
///   x_n = x0 + start_position a h_1^2 + drift (v0 + start_velocity a h_1) t
///         + 1/2 drift kick a t^2 + (alpha - 1/2 drift kick) a S + read_position a h_n^2
///   v_n = v0 + start_velocity a h_1 + kick a t + read_velocity a h_n
struct VariableStepLaw {
  Fraction drift;
  Fraction kick;
  Fraction alpha;
  Fraction start_position;
  Fraction start_velocity;
  Fraction read_position;
  Fraction read_velocity;
  std::vector<std::string> letters;  ///< names of the letters of these, see letters.hpp

  /// Whether positions are exact for every list of steps.
  bool exact() const;
  /// Whether only the sum of squares is missing: x += drift = 1, kick = 1, nothing at start or finish.
  bool only_squares() const;
};

/// What is known about an integrator whose steps have any lengths, under a constant acceleration.
struct VariableSteps {
  /// Proved by induction on n: the step itself is run in letters from the claimed x_n and v_n, and must give
  /// the claimed x_(n+1) and v_(n+1) as polynomials in t, S, h, h_1.
  std::optional<VariableStepLaw> law;
  std::string reason;  ///< why there is no law of this form
};

/// throws  BadInput  for a value of an unknown parameter
VariableSteps variable_steps(const Program& program, const Values& given = {});

/// Exact minus computed position after 1, 2, ..., frames steps h_1, h_2, ... as formulas in x0, v0, a, h_1,
/// h_2, ..., by running the step with letters for lengths.
///
/// Fewer when the letters do not suffice.
/// throws  Undefined, Unable  when the step cannot be followed in letters
std::vector<Expr> unrolled_shortfalls(const Program& program, int frames, const Values& given = {});

/// Exact minus computed position after n steps by a law, as a formula in a, h_1, h_k, h_n, n, t, v0; 0 when
/// it is exact.
Expr shortfall_formula(const VariableStepLaw& law);
/// What one step of length h adds to the position and to the velocity, as formulas in h, v, a.
Expr position_change(const VariableStepLaw& law);
Expr velocity_change(const VariableStepLaw& law);
/// What has to be added to the position at the end of each step of length h, when only squares are missing.
Expr square_term(const VariableStepLaw& law);

/// Whether positions are exact for every list of steps.
struct ListExactness {
  std::string integrator;
  std::optional<bool> exact;  ///< proved or refuted; nothing when not decided
  std::string shortfall;      ///< of a refuted one: the law's formula, or the first frame that misses
  std::string reason;         ///< why it has no law, or is not decided
};
ListExactness list_exactness(const Program& program, const Values& given = {});

/// The integrator with x += (1/2 - alpha) a h^2 at the end of each step, which is exact for every list of
/// steps.
///
/// throws  Undefined  when a law of squares alone does not hold, or there is nothing to correct
Program with_square_term(const Program& program, const VariableSteps& steps);

}  // namespace shortfall
