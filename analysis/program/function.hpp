// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace shortfall {

/// The functions of scalars that an expression may call. The first five stand in programs; formulas may use
/// all of them. In `solves` log(s) is a rate per second: (1 - c)^t = exp(log(1 - c) t).
enum class Function { sqrt, exp, pow, max, min, cos, sin, acos, atan, cosh, sinh, acosh, log };

std::optional<Function> function_named(std::string_view name);
std::string_view name_of(Function f);
/// How many values it takes.
int arity(Function f);
/// Whether a program may call it, or only a formula.
bool stands_in_programs(Function f);

}  // namespace shortfall
