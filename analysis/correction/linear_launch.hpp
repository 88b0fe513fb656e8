// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/correction/open_step.hpp"

namespace shortfall {

/// A combination of a position, a velocity and the force with its derivatives by time, f, f', f'', ...
struct ForceForm {
  Fraction x;
  Fraction v;
  std::vector<Fraction> f;
};

/// What makes every frame exact once the spectrum of the step is that of the exact flow.
struct LinearLaunch {
  std::vector<Fraction> force;  ///< the integrator is given the sum of force[j] f^(j)
  std::vector<std::pair<std::string, ForceForm>>
      start;  ///< target := combination of x0, v0 and the force at t = 0
  bool by_states =
      false;  ///< the targets are carried vectors, which replace what `start` makes; else x0 and v0
  std::optional<ForceForm> read_out;  ///< the true velocity, of x_n, v_n and the force at t = n h
  std::string obstruction;            ///< why there is none; empty when there is one
};

/// What the launch is solved from.
struct LaunchProblem {
  const OpenStep& step;
  std::function<Fraction(const Fraction&)>
      put;         ///< puts the matched k and c into a function of the open ones
  Fraction trace;  ///< of the matched pair of eigenvalues, in the same letters as put gives
  Fraction determinant;
  Fraction k, c;          ///< the true ones
  Fraction cosine, sine;  ///< C and S
};

/// Solves for the force, the launch and the read-out, exactly, and puts them back into what they were solved
/// from.
///
/// A state that M^2 - T M + D takes to 0 stays so, and its positions satisfy the exact flow's recurrence.
/// Such states form a plane; the one with the right first two positions is right for ever. Under a force that
/// is polynomial in time the same holds for the difference from a motion that is polynomial in time, which
/// both sides have: the force is chosen so that these agree.
LinearLaunch linear_launch(const LaunchProblem& problem);

/// Terms of all its numerators and denominators: how long its formulas are.
std::size_t term_count(const LinearLaunch& launch);

}  // namespace shortfall
