// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// Frame after frame of an integrator whose coefficients need not be rational, in balls: what ExactTrajectory
/// is for rational ones. Balls get wider by a fraction of a bit a step, for which there is room beforehand.
class BallTrajectory {
 public:
  /// param   question  steps and digits are not looked at
  /// throws  BadInput  for a letter of the force without a number;  Unable  when the step is not linear
  BallTrajectory(const Program& program, const NumericQuestion& question);

  /// At a frame no earlier than the one before, in at least so many bits. How wide the ball is, it says
  /// itself: asked for more bits, it is narrower.
  Ball position(std::int64_t frame, int bits);

 private:
  void restart(std::int64_t frame, int bits);

  Program program_;
  NumericQuestion question_;
  int bits_ = 0;              ///< asked for
  std::int64_t planned_ = 0;  ///< frames that there is room for
  std::int64_t frame_ = 0;
  std::vector<std::vector<Ball>> step_;
  std::vector<Ball> state_, report_;
};

}  // namespace shortfall
