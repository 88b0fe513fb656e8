// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/correction/linear_kit.hpp"
#include "analysis/program/print.hpp"
#include "notebooks-export/named_formulas.hpp"

namespace shortfall {

/// How k_new and c_new are found where they are roots of equations, why these exist, and how far: some lines.
std::string implicit_text(const LinearKit& kit, NamedFormulas& formulas);

/// Equations as formulas that are 0, the leading differences from the true values, the range of the branch.
nlohmann::ordered_json implicit_json(const LinearKit& kit);

}  // namespace shortfall
