// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/motion/force.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// What a motion after n steps is asked for: all numbers, all exact.
struct NumericQuestion {
  Force force;  ///< with k, c and its polynomial as numbers
  Values parameters;
  int substeps = 1;
  Rational h = Rational(1, 50);  ///< s, the frame
  Rational x0;                   ///< m
  Rational v0;                   ///< m/s
  Rational steps;                ///< n, whole, from 0 to 10^100
  int digits = 50;               ///< significant ones wanted of every answer
};

/// A number of which every digit shown is certain.
struct CertainNumber {
  Ball ball;
  std::optional<Rational> exact;       ///< where it is known exactly and is not long
  std::optional<std::string> decimal;  ///< correctly rounded to so many digits; empty when the ball does not
                                       ///< decide it: then all that is known is the ball
};

/// Position and velocity after n steps as an integrator makes them, and as they are.
struct NumericMotion {
  Rational time;      ///< t = n h
  Expr acceleration;  ///< of the true motion, with numbers: the question's, and the integrator's own damping
  CertainNumber position, velocity;
  CertainNumber exact_position, exact_velocity;
  CertainNumber position_shortfall, velocity_shortfall;  ///< exact minus computed
  std::vector<std::string> assumed;  ///< what the integrator's own text assumes, and was used
  int states = 0;                    ///< rows of the matrix that is raised to the power n
  int bits = 0;                      ///< working precision at last
};

/// The n-step map is the n-th power of a matrix of rationals, by repeated squaring: exactly while that is
/// short, in balls otherwise, with as much precision as the digits need. Nothing is rounded on the way in the
/// sense of floating point: the result is that of the integrator in exact arithmetic.
///
/// throws  BadInput   for a letter without a number, or a bad number of steps
///         Undefined  when a stage is singular for these numbers;  Unable  when the step is not linear
NumericMotion numeric_motion(const Program& program, const NumericQuestion& question);

}  // namespace shortfall
