// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/function.hpp"

#include <algorithm>
#include <array>

namespace shortfall {

namespace {

/// In the order of the enumeration.
constexpr std::array<std::string_view, 13> kNames{"sqrt", "exp",  "pow",  "max",  "min",   "cos", "sin",
                                                  "acos", "atan", "cosh", "sinh", "acosh", "log"};

}  // namespace

std::optional<Function> function_named(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Function>(found - kNames.begin());
}

std::string_view name_of(Function f) { return kNames[static_cast<std::size_t>(f)]; }

int arity(Function f) { return f == Function::pow || f == Function::max || f == Function::min ? 2 : 1; }

bool stands_in_programs(Function f) { return f <= Function::min; }

}  // namespace shortfall
