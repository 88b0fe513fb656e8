// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>

#include "analysis/program/catalogue_data.hpp"

namespace shortfall {

/// The .lesson files as they lay in lessons/ when the library was built, sorted by path.
std::span<const CatalogueFile> lesson_files();

/// The PNG files in lessons/pictures/ by their names, in hexadecimal digits: "falling-short-1.png" is what
/// the first cell of the lesson that draws has drawn.
const std::map<std::string, std::string>& lesson_pictures();

}  // namespace shortfall
