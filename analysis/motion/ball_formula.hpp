// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "analysis/algebra/ball.hpp"
#include "analysis/program/expression.hpp"

namespace shortfall {

/// A formula in balls: a number that is certain, with the radius that it has.
///
/// throws  Error  for a name without a value, or what is no function of balls
Ball ball_value(const Expr& formula, const std::map<std::string, Ball>& values, int bits);

}  // namespace shortfall
