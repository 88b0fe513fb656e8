// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture.hpp"

#include "cli/output.hpp"
#include "notebooks-export/figure_gnuplot.hpp"

namespace shortfall::cli {

void write_picture(const Figure& figure, const std::string& path) {
  try {
    write_output(image(figure, image_format(path)), path);
  } catch (const ProgramError& e) {
    throw OutputError(e.what());
  }
  say("wrote " + path);
}

void check_picture_name(const std::string& path) {
  if (!path.empty()) image_format(path);
}

}  // namespace shortfall::cli
