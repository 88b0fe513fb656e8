// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// A function that moves a body by any dt under a constant acceleration with drag: the exact motion, hence
/// the same at every frame rate.
///
/// Near c dt = 0 differences such as 1 - exp(-c dt) lose their digits; a Taylor series takes over there, and
/// c = 0 is allowed.
std::string damping_code(Language language);

}  // namespace shortfall
