// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/function.hpp"

#include <algorithm>
#include <array>

#include "analysis/algebra/comma_list.hpp"

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

bool is_one_of(Functions functions, Function f) {
  switch (functions) {
    case Functions::none:
      return false;
    case Functions::of_programs:
      return f <= Function::min;
    case Functions::of_scenes:
      return f != Function::acos && f != Function::atan && f != Function::acosh;
    case Functions::all:
      break;
  }
  return true;
}

std::string function_list(Functions functions) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (is_one_of(functions, static_cast<Function>(i))) names.emplace_back(kNames[i]);
  return comma_list(names);
}

}  // namespace shortfall
