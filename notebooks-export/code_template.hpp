// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The file of a corrected jump in a language, with @name@ where something is to be filled in.
std::string_view jump_template(Language language);

/// A text with its @name@ filled in. One that stands alone on its line becomes as many lines as there are,
/// indented as it is, or none.
///
/// throws  Error  for a name without a value
std::string filled(std::string_view text, const std::map<std::string, std::vector<std::string>>& values);

}  // namespace shortfall
