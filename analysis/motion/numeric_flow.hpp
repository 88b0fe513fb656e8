// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/motion/numeric_motion.hpp"
#include "analysis/problems/extra_letters.hpp"

namespace shortfall {

/// The true motion of a question after a time t: a polynomial in t, and what is free about it.
class NumericFlow {
 public:
  /// param   question  with k, c and the force polynomial as numbers, or as functions of numbers: an engine
  /// that
  ///                   keeps (1 - c)^t of a velocity damps by -log(1 - c), which is irrational
  /// param   extras    what the letters of such functions stand for
  NumericFlow(const NumericQuestion& question, const Rational& t, std::vector<ExtraLetters::Extra> extras);

  /// Position and velocity where they are rational, and known to be.
  std::array<std::optional<Rational>, 2> exact() const;
  std::array<Ball, 2> balls(int bits) const;

 private:
  bool rational_;
  Fraction k_, c_;
  Rational t_;
  std::vector<ExtraLetters::Extra> extras_;
  Fraction position_, velocity_;  // of the polynomial
  Fraction free_x_, free_v_;      // first values of the rest
};

}  // namespace shortfall
