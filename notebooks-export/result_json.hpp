// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"

namespace shortfall {

/// Schema shortfall.derive/1. Formulas are strings of the .integrator language.
nlohmann::ordered_json as_json(const Derivation& derivation, const CorrectionKit* kit);

/// Schema shortfall.correct/1.
nlohmann::ordered_json as_json(const CorrectionKit& kit, const Derivation& derivation);

}  // namespace shortfall
