// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/correction/kit.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The corrections of the best option as functions of their letters, each with a comment that says what it is
/// added to and when.
///
/// throws  Undefined  when there is no correction, with the obstruction
std::string kit_code(const CorrectionKit& kit, const Derivation& derivation, Language language);

}  // namespace shortfall
