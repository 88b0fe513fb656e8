// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace shortfall {

/// The functions of scalars that an expression may call. The first five stand in programs; formulas may use
/// all of them. In `solves` log(s) is a rate per second: (1 - c)^t = exp(log(1 - c) t).
enum class Function { sqrt, exp, pow, max, min, cos, sin, acos, atan, cosh, sinh, acosh, log };

std::optional<Function> function_named(std::string_view name);
std::string_view name_of(Function f);
/// How many values it takes.
int arity(Function f);
/// Which functions besides the force may be called: those of steps, of the forces of scenes (whose series are
/// known), or all, in formulas.
enum class Functions { none, of_programs, of_scenes, all };

bool is_one_of(Functions functions, Function f);

/// "sqrt, exp, pow, max, min", for messages.
std::string function_list(Functions functions);

}  // namespace shortfall
