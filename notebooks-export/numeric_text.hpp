// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/motion/numeric_motion.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {

/// The numbers after n steps as a person reads them: computed, true, the shortfall; how certain each is.
std::string as_text(const NumericMotion& motion, const NumericQuestion& question,
                    const std::string& integrator, Style style);

/// Schema shortfall.derive/1; a number that is known exactly is a string "p/q", others have decimal, digits,
/// radius.
nlohmann::ordered_json as_json(const NumericMotion& motion, const NumericQuestion& question,
                               const std::string& integrator);

}  // namespace shortfall
