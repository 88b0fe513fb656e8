// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analysis/program/catalogue_data.hpp"

namespace shortfall {

/// The .lesson files as they lay in lessons/ when the library was built, sorted by path.
std::span<const CatalogueFile> lesson_files();

}  // namespace shortfall
