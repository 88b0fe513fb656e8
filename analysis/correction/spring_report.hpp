// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/correction/kit_numbers.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// A spring -k x - c v for each unit of mass, and how it is stepped.
struct SpringQuestion {
  Rational k;            ///< 1/s^2
  Rational c;            ///< 1/s
  bool rounded = false;  ///< k and c come from a frequency: 60 digits of them
  Rational h = Rational(1, 60);
  int substeps = 1;
  bool held = false;  ///< the force is computed once a frame and held over the substeps
  Values parameters;
};

/// k = (2 pi f)^2 and c = 2 ratio (2 pi f), rounded to 60 digits.
///
/// param   frequency  Hz, of the undamped spring
void set_spring(SpringQuestion& question, const Rational& frequency, const Rational& damping_ratio);

/// What the spring of the step really is: the eigenvalues of one frame, taken for those of a damped spring.
struct EffectiveSpring {
  Ball trace;
  Ball determinant;
  bool oscillates = false;     ///< two complex eigenvalues
  std::optional<bool> stable;  ///< no eigenvalue larger than 1 and none of size 1 twice; unknown: undecided
  Ball growth;  ///< the larger eigenvalue's size to the power 1/h: amplitude after 1 s over before
  std::optional<Ball> frequency;      ///< Hz, undamped, sqrt(rate^2 + angular^2)/2 pi; where it oscillates
  std::optional<Ball> damping_ratio;  ///< negative where the amplitude grows
};

struct SpringReport {
  std::string integrator;
  SpringQuestion question;
  Expr trace;  ///< of one frame, exact, in h, k, c and parameters
  Expr determinant;
  EffectiveSpring effective;
  EffectiveSpring truth;
  std::optional<KitNumbers> kit;  ///< what to give it instead
  std::string no_kit;             ///< why there is none
};

/// The effective spring of an integrator, from trace and determinant of one frame.
///
/// throws  BadInput  for a stiffness that is not positive or a negative damping;  Unable  when x and v alone
/// do not carry the motion
SpringReport spring_report(const Program& program, const SpringQuestion& question);

/// Substeps over which the force that is computed at the beginning of the frame is held.
Program held_over_substeps(const Program& program, int substeps);

}  // namespace shortfall
