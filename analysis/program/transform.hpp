// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/program/program.hpp"

namespace shortfall {

/// The integrator that takes `count` steps of h / count for each step of its own; its h is the frame.
///
/// throws  BadInput  when count is not from 1 to 10000
Program substepped(const Program& program, int count);

/// The one parameter that says how often a `substeps` of the step block repeats, when there is one.
std::optional<std::string> substep_parameter(const Program& program);

/// The integrator as closed forms take it, in plain statements: no limit acts, every `when` holds, no impulse
/// is given, a force that is held has a name.
Program undisturbed(const Program& program);

/// The integrator with its roots and approximate coefficients as numbers: rationals within 10^-digits,
/// relatively.
Program with_numbers(const Program& program, int digits);

}  // namespace shortfall
