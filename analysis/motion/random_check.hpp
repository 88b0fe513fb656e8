// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/motion/closed_form.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// A check with random numbers, by another route than the derivation's: no letters, no linear forms.
struct RandomCheck {
  int trials = 0;
  int steps = 0;   ///< of each trial
  int digits = 0;  ///< that agree; 0: equal as rational numbers
  bool agrees = false;
};

/// The force -k x - c v of a check; numbers where a user fixed them, otherwise drawn.
struct RandomForce {
  bool spring = false;
  bool damper = false;
  std::optional<Rational> k;
  std::optional<Rational> c;
};

/// Steps random numbers and holds a closed form against them: in rational numbers, or with 80 digits when the
/// integrator has irrational coefficients, exp or pow.
///
/// Parameters that are letters in the closed form have their defaults in the first trial, then numbers drawn
/// from between 0 and 1.
RandomCheck random_check(const Program& program, const Values& given, const RandomForce& force,
                         const StepMap& map, const ClosedForm& form, int trials, int steps);

}  // namespace shortfall
