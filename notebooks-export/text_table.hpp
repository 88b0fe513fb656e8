// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace shortfall {

/// How many places a text takes on a terminal: characters, not bytes.
std::size_t width_of(const std::string& text);

/// With blanks behind it, so that it takes at least so many places.
std::string padded(std::string text, std::size_t width);

/// A table with its columns aligned, the first to the left, the others to the right.
std::string aligned_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace shortfall
