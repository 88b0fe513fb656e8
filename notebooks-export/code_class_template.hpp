// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The file of an integrator as a class, with @name@ where something is to be filled in; see
/// code_template.hpp.
std::string_view class_template(Language language);

}  // namespace shortfall
