// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/modular.hpp"
#include "analysis/algebra/rational.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/progress.hpp"

namespace shortfall {

class ExactTrajectory;

/// A number of a trajectory at the frame where the trajectory stands: it moves with it, and must not outlive
/// it. It is held as N / (R D0 D^n), not reduced; what is asked of it costs no more than the answer needs.
class ExactReading {
 public:
  int sign() const;
  /// In lowest terms: one greatest common divisor of long integers.
  Rational rational() const;
  /// From the leading digits only, whatever the length of the number.
  ///
  /// param   bits  that are certain at least: the radius is at most |value| 2^-bits
  Ball ball(int bits) const;
  /// Correctly rounded to so many significant digits (ties away from zero).
  std::string significant(int digits) const;
  /// Correctly rounded to so many digits after the point (ties away from zero).
  std::string decimal(int places) const;
  /// This minus a number, that of a floating-point run for instance: exactly 0, or to `bits` bits of the
  /// difference however small it is.
  Ball minus(const Rational& value, int bits) const;
  bool equals(const Rational& value) const;
  /// throws  Undefined  when 2^61 - 1 divides the denominator
  Modular fingerprint() const;
  /// Binary digits of the numerator before reduction.
  std::size_t bits() const;

 private:
  friend class ExactTrajectory;
  ExactReading(const ExactTrajectory& trajectory, bool velocity)
      : trajectory_(&trajectory), velocity_(velocity) {}

  const ExactTrajectory* trajectory_;
  bool velocity_;
};

/// The trajectory of an integrator in exact arithmetic, frame by frame.
///
/// numeric_motion answers for one n, however large, and compares with the true motion; this is the whole way
/// there, of which every frame can be read. Both are made of the same StepMatrix. A state is held once, so
/// that memory is the digits of one state; they grow by log2(D) bits a step, see exact_step.hpp.
class ExactTrajectory {
 public:
  /// param   question  steps and digits are not looked at
  /// throws  BadInput   for a letter of the force without a number
  ///         Unable  when there is none: irrational coefficients, a step that is not linear
  ///         Undefined  when a stage is singular
  ExactTrajectory(const Program& program, const NumericQuestion& question);
  ExactTrajectory(ExactTrajectory&&) noexcept;
  ExactTrajectory& operator=(ExactTrajectory&&) noexcept;
  ~ExactTrajectory();

  std::int64_t frame() const;
  Rational time() const;  ///< n h
  ExactReading position() const { return {*this, false}; }
  ExactReading velocity() const { return {*this, true}; }

  /// So many steps by stepping; frames at which nobody looks cost a fifth or less of the others.
  ///
  /// throws  Unable  when a number would need more than 256 MB
  void advance(std::int64_t steps = 1);
  /// So many steps by squaring: for one far frame alone.
  void jump(std::int64_t steps);

  /// D: a step multiplies denominators by it.
  Rational denominator_of_a_step() const;
  /// Whether the state is held in words of 128 bits at present, not in GMP integers.
  bool in_words() const;
  /// What the integrator's own text assumes, and was used.
  const std::vector<std::string>& assumed() const;

 private:
  friend class ExactReading;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Shows every frame from 0 to `frames` to `visit`, which says whether to go on; the frame that was the last.
///
/// param   progress  is told now and then; what it throws passes through
std::int64_t exact_trajectory(const Program& program, const NumericQuestion& question, std::int64_t frames,
                              const std::function<bool(const ExactTrajectory&)>& visit,
                              const Progress& progress = {});

}  // namespace shortfall
