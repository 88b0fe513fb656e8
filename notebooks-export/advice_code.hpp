// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/trade/advice.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The step that is advised, to be pasted: what is done once (launch included), what is done every step, what
/// is done for what is shown. It calls acceleration(x, v, t), which the user has: the sum of the forces to
/// model.
///
/// throws  Unable  when nothing is advised, or its stages stay implicit
std::string advice_code(const Advice& advice, Language language);

}  // namespace shortfall
