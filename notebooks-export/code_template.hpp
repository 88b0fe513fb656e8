// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/program/embedded_file.hpp"
#include "notebooks-export/code_language.hpp"

namespace shortfall {

/// The files of templates/, as jump.cs.in.
std::span<const EmbeddedFile> code_templates();

/// A file of templates/ in a language, with @name@ where something is to be filled in: "jump" is a corrected
/// jump, "class" an integrator as a class.
///
/// throws  Error  for a name without a file
std::string_view code_template(std::string_view name, Language language);

/// A text with its @name@ filled in. One that stands alone on its line becomes as many lines as there are,
/// indented as it is, or none.
///
/// throws  Error  for a name without a value
std::string filled(std::string_view text, const std::map<std::string, std::vector<std::string>>& values);

}  // namespace shortfall
