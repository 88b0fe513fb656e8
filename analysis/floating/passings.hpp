// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/floating/float_run.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

/// How far a motion is from a level, frame by frame; made anew for every pass.
class Distances {
 public:
  virtual ~Distances() = default;
  /// At a frame no earlier than the one asked for before, to so many bits where it is not 0.
  virtual Ball at(std::int64_t frame, int bits) = 0;
};
/// A motion as its distances from the level.
using MotionFromLevel = std::function<std::unique_ptr<Distances>()>;

/// An integrator's exact map.
///
/// param   launch  the velocity at the start where it is irrational; the question's v0 is then not looked at
MotionFromLevel map_distances(const FloatQuestion& question, const Rational& level,
                              const std::optional<Surd>& launch = {});

/// A jump's parabola, u t - g t^2/2, at the frames' times.
MotionFromLevel parabola_distances(const Rational& h, const Surd& launch, const Rational& g);

/// The true motion under the question's force.
MotionFromLevel true_distances(const FloatQuestion& question, const Rational& level);

/// Passings through the level as somebody reads them who has the frames only: the frames at which the sign
/// has changed, the time between that frame and the one before it by a straight line.
///
/// What is 0 at a frame passes there. Motions are on the side `side` before frame 1.
struct Passings {
  std::vector<std::int64_t>
      frames;  ///< from 1; as many as were asked for, fewer when `most` frames do not have them
};
Passings passings(const MotionFromLevel& motion, int side, std::size_t count, std::int64_t most,
                  const std::string& what, const Progress& progress = {});

/// The time of each passing, s.
std::vector<Ball> passing_times(const MotionFromLevel& motion, const Passings& passings, const Rational& h,
                                int bits);

/// The same of a run, all in rational numbers.
struct RunPassings {
  std::vector<std::int64_t> frames;
  std::vector<Rational> times;
  std::optional<std::int64_t> not_finite_at;
};
RunPassings run_passings(FloatRun& run, const Rational& level, int side, std::size_t count, std::int64_t most,
                         const Rational& h, const FloatFormat& format, const Progress& progress = {});

}  // namespace shortfall
