// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/identify/candidate.hpp"
#include "analysis/identify/observations.hpp"

namespace shortfall {

/// How a body was launched.
enum class Launch {
  velocity,  ///< it had it in row 0, or it was set right after row 0 was written
  impulse,   ///< in the first frame, by an impulse
};

/// A number of a fit and how far it can be wrong.
struct Fitted {
  double value = 0;
  double spread = 0;
};

/// The numbers with which a map comes nearest to a log.
struct Fit {
  using Triple = std::array<Fitted, 3>;

  Fitted c, k;          ///< damping number, spring constant over the mass
  Triple x0, v0, a, j;  ///< of each axis: a is the constant part of the acceleration
  Launch launch = Launch::velocity;
  int free = 0;      ///< how many numbers were fitted
  double worst = 0;  ///< the largest residual, in halves of a unit in the last place
  double worst_position = 0, worst_velocity = 0;  ///< in the log's units
  double log_likelihood =
      0;  ///< each number was rounded: the chance that it was rounded to what stands there
};

/// What is fitted besides the launch and the constant acceleration.
struct FitQuestion {
  bool damping = false;
  bool spring = false;
  Launch launch = Launch::velocity;
  double rate = 0;          ///< guess of the damping, per second
  double stiffness = 0;     ///< guess of k
  bool invariants = false;  ///< whether trace and determinant of a frame are known
  double trace = 0, determinant = 0;
};

/// The best parameters of a candidate. Given damping and spring the frames depend linearly on all the others,
/// which least squares find; GSL's Levenberg-Marquardt finds these two. Where a log is rounded, the largest
/// residual is then made as small as possible.
///
/// shape   none where the map explodes or has no such parameter
std::optional<Fit> fit(const Candidate& candidate, const Observations& observations,
                       const FitQuestion& question);

/// Damping rate and stiffness as differences of the positions show them, over a stride of rows.
struct RateGuess {
  double rate = 0;
  double stiffness = 0;
};
RateGuess rate_guess(const Observations& observations, std::size_t stride, bool spring);

}  // namespace shortfall
