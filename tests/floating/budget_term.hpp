// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/budget.hpp"

namespace shortfall::testing {

/// What a line of a budget says under a name.
inline const Ball& term(const BudgetLine& line, const std::string& name) {
  for (const BudgetTerm& t : line.terms)
    if (t.name == name) return t.value;
  throw Error("no term " + name);
}

}  // namespace shortfall::testing
