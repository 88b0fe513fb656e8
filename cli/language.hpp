// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "notebooks-export/code_language.hpp"

namespace shortfall::cli {

/// The language that a user names: "csharp", "c#", "cs".
///
/// param   option  where it was named: "--lang"
/// param   beside  what else might be said there, for the message: ", or all"
/// throws  BadInput  with those that there are, and the nearest
Language language_of(const std::string& word, const std::string& option = "--lang",
                     const std::string& beside = "");

}  // namespace shortfall::cli
