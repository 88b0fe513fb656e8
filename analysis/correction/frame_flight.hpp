// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/algebra/surd.hpp"
#include "analysis/problems/undisturbed_numbers.hpp"
#include "analysis/program/run.hpp"

namespace shortfall {

/// The end of a frame of a throw: height = launch * rise - g * fall, and the same for the velocity.
struct FlownFrame {
  Rational t;  ///< seconds since the launch
  Rational h;  ///< length of the frame; 0 for frame 0
  Rational rise, fall;
  Rational rise_velocity, fall_velocity;

  Surd height(const Surd& launch, const Rational& g) const { return launch * rise - Surd(g * fall); }
  Surd velocity(const Surd& launch, const Rational& g) const {
    return launch * rise_velocity - Surd(g * fall_velocity);
  }
};

/// A body thrown straight up from the ground and stepped with frames of given lengths, in exact arithmetic.
///
/// What an integrator carries from frame to frame stays as it is when the length changes: a multistep method,
/// which takes its history for equal steps, does what its map does. `start` runs with the first length,
/// `finish` with that of the frame which has just ended.
class FrameFlight {
 public:
  static constexpr std::size_t kMost = 100'000;  ///< frames that are stepped

  /// param   steps   seconds, each greater than 0, at least one
  /// param   repeat  whether the list begins anew when it is over
  /// throws  BadInput  as lower does, or for a step that is not positive
  FrameFlight(const Program& program, std::vector<Rational> steps, bool repeat = false, int substeps = 1,
              const Values& given = {});
  FrameFlight(const FrameFlight&) = delete;  // runs refer to the tape
  FrameFlight& operator=(const FrameFlight&) = delete;

  const Program& program() const { return program_; }  ///< substeps included
  const std::vector<Rational>& steps() const { return steps_; }
  bool repeats() const { return repeat_; }

  /// Whether the list has a frame n; frame 0 is the launch.
  bool has(std::size_t n) const { return repeat_ || n <= steps_.size(); }
  /// throws  Unable  past frame kMost
  const FlownFrame& frame(std::size_t n);

 private:
  void record(const Rational& t, const Rational& h);

  Program program_;
  Tape tape_;
  std::vector<Rational> steps_;
  bool repeat_;
  UndisturbedNumbers weightless_;
  UndisturbedNumbers heavy_;
  Run<UndisturbedNumbers> free_;
  Run<UndisturbedNumbers> dropped_;
  std::vector<FlownFrame> frames_;
};

}  // namespace shortfall
