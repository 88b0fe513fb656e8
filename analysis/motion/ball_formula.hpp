// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/algebra/ball.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/problems/extra_letters.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// A formula in balls: a number that is certain, with the radius that it has.
///
/// throws  Error  for a name without a value, or what is no function of balls
Ball ball_value(const Expr& formula, const std::map<std::string, Ball>& values, int bits);

/// Values of all letters, by number: 0 but for those that stand for roots, exp, pow and logarithms of
/// numbers.
///
/// throws  Unable  for a function that balls do not compute
std::vector<Ball> letter_balls(const std::vector<ExtraLetters::Extra>& extras, int bits);

/// A fraction of such letters.
Ball ball_value(const Fraction& fraction, const std::vector<Ball>& letters, int bits);

}  // namespace shortfall
