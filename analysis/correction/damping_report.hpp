// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/program/expression.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// What one damping number does at one frame time.
struct DampingAtRate {
  Rational h;                ///< s
  Ball share;                ///< of the velocity that one frame leaves
  Ball kept;                 ///< of the velocity after 1 s: share^(1/h); 0 where share is 0
  std::optional<Ball> rate;  ///< 1/s, the c of exp(-c t) that decays so; empty where share <= 0
  Ball terminal;             ///< m/s, the speed at which gravity and damping balance, as reported
  Ball coast;                ///< m, how far a body coasts for each m/s of its speed
};

/// Damping that an integrator does itself: v <- share v + push a in every frame.
struct DampingReport {
  std::string integrator;
  Values parameters;
  int substeps = 1;
  Rational g;
  Expr share;                            ///< exact, in h and the parameters
  Expr terminal;                         ///< terminal speed in g, h and the parameters
  Expr coast;                            ///< distance for each m/s
  std::vector<std::string> assumptions;  ///< under which these formulas hold
  bool assumed_hold = true;              ///< whether they do for these numbers
  DampingAtRate here;
  std::vector<DampingAtRate> rates;  ///< the same number at 30, 60, 120 and 144 Hz
  Expr solves;                       ///< the equation it is meant for; or null
  std::optional<Ball> true_rate;     ///< 1/s, of that equation
  std::optional<Ball> true_terminal;
};

/// Terminal speed, what is left after a second, how far a body coasts; and how all that depends on the frame
/// time.
///
/// param   parameters  all that the user gave; the integrator's defaults for the rest
/// throws  BadInput  for a negative damping, or when these parameters do not damp;  Unable  when velocity
/// and damping are not one number
DampingReport damping_report(const Program& program, const Values& parameters, const Rational& h,
                             const Rational& g, int substeps = 1);

/// How programs write down damping: what one frame leaves of a velocity.
enum class DampingConvention { linear, implicit, power, exponential, per_frame };
inline constexpr int kDampingConventions = 5;

/// "1 - c h", as an expression in c and h.
Expr share_of(DampingConvention convention);
/// The number c of `to` that leaves the same share of a velocity in a frame of h as the number c of `from`.
Expr converted_damping(DampingConvention from, DampingConvention to);
/// The number c of a convention from the share s that a frame leaves.
Expr damping_from_share(DampingConvention to);
Ball damping_number(DampingConvention to, const Ball& share, const Rational& h);
std::string name_of(DampingConvention convention);

}  // namespace shortfall
