// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// What a name is given, and how that was computed.
using Target = std::pair<std::string, Expr>;

/// Statements that give each target its value, all computed from what the names held before. What is computed
/// more than once becomes a named line; the operations are those of the expressions, in their order.
///
/// param   taken  names that new lines may not have
/// throws  BadInput  for more operations than a step can be meant to have
std::vector<Statement> traced_lines(const std::vector<Target>& targets, const std::set<std::string>& taken);

}  // namespace shortfall
