// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/embedded_file.hpp"

namespace shortfall {

/// The .lesson files of lessons/, sorted by path.
std::span<const EmbeddedFile> lesson_files();

/// The PNG files of lessons/pictures/: "falling-short-1.png" is what the first cell of the lesson that draws has drawn.
std::span<const EmbeddedFile> lesson_pictures();

}  // namespace shortfall
