// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/trade/scene.hpp"

namespace shortfall::cli {

/// A scene from its file; with another end when `until` is not empty.
///
/// throws  as read_scene; BadInput for an end that is none
Scene scene_from(const std::string& path, const std::string& until);

/// "a,b" -> a, b; blanks around them are left out.
std::vector<std::string> words_of(const std::string& list);

}  // namespace shortfall::cli
