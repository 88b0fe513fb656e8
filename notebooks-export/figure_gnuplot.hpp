// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "notebooks-export/figure.hpp"

namespace shortfall {

enum class ImageFormat { svg, png, pdf };

/// The format that a file's name ends in.
///
/// throws  BadInput  for other endings
ImageFormat image_format(const std::string& path);

/// A figure as a script for gnuplot that writes the image to its standard output.
///
/// Texts stand in single quotes only, with quotes doubled and control characters made blanks: gnuplot would
/// run what stands in backquotes between double quotes. Everything else is numbers.
std::string gnuplot_script(const Figure& figure, ImageFormat format);

/// Something outside shortfall failed: gnuplot is not installed, or it refused.
class ProgramError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether gnuplot is found on the search path.
bool gnuplot_is_here();

/// The bytes of the image, drawn by gnuplot.
///
/// throws  ProgramError  when gnuplot is missing or fails
std::string image(const Figure& figure, ImageFormat format);

}  // namespace shortfall
