// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "notebooks-export/figure.hpp"

namespace shortfall::cli {

/// Draws a figure into a file, in the format that its name ends in, and says so on stderr.
///
/// throws  BadInput  for another ending;  OutputError  where gnuplot is missing or fails, or the file cannot
/// be made
void write_picture(const Figure& figure, const std::string& path);

/// Refuses a name whose ending is no format of pictures, before any work is done; empty names are fine.
///
/// throws  BadInput
void check_picture_name(const std::string& path);

}  // namespace shortfall::cli
