// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/algebra/modular.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/program.hpp"

namespace shortfall {

/// The trajectory modulo the prime 2^61 - 1: a few nanoseconds a step however long the exact numbers are.
///
/// Two formulas that agree here at a frame are "checked", never "proved": different numbers collide with
/// probability about 2^-61.
class ExactFingerprint {
 public:
  /// param   question  steps and digits are not looked at
  /// throws  as ExactTrajectory does;  Undefined  when 2^61 - 1 divides a denominator
  ExactFingerprint(const Program& program, const NumericQuestion& question);

  std::int64_t frame() const { return frame_; }
  Modular position() const { return read(position_); }
  Modular velocity() const { return read(velocity_); }

  void advance(std::int64_t steps = 1);  ///< one by one
  void jump(std::int64_t steps);         ///< by squaring the matrix

 private:
  Modular read(const std::vector<Modular>& row) const;

  std::vector<Modular> matrix_;  // row by row
  std::vector<Modular> state_;
  std::vector<Modular> position_, velocity_;
  std::int64_t frame_ = 0;
};

}  // namespace shortfall
