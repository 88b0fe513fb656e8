// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/correction/jump_flight.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// The velocity which, added to every launch, makes every frame of a throw exact; or why there is none.
struct LaunchCorrection {
  bool exists = false;
  Rational per_gravity;  ///< seconds: what is added is g * per_gravity
  Expr formula;          ///< the same in g, h (a frame) and the parameters
  std::string reason;    ///< why it does not exist

  Rational value(const Rational& g) const { return g * per_gravity; }
};

/// By matching coefficients: launch * rise(n) - g * fall(n) = (launch - correction) t - g t^2 / 2 with t = n
/// dt.
///
/// throws  Unable  when the flight is only known frame by frame and no frame decides
LaunchCorrection launch_correction(const Flight& flight);

/// The height H such that a body leaves the ground (some frame is above it) if and only if it aims higher.
struct LiftOff {
  std::optional<Rational> height;  ///< 0 when every jump leaves the ground
  std::string reason;              ///< why it is not known
};
LiftOff lift_off(const Flight& flight, const Rational& g);

}  // namespace shortfall
