// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "analysis/program/program.hpp"
#include "analysis/program/token_reader.hpp"

namespace shortfall {

/// The highest degree of a root's equation.
inline constexpr int kHighestRootDegree = 12;

/// The real number that a root's equation and its `near` single out.
///
/// throws  SyntaxError  when an expression is no polynomial in the name with rational coefficients, or the
///                      equation has no real solution, or several and no `near`
std::shared_ptr<const RealRoot> chosen_root(const Root& root, const TokenReader& in);

}  // namespace shortfall
