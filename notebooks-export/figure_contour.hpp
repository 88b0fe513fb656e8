// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "notebooks-export/figure.hpp"

namespace shortfall {

/// Values of a function on a rectangular grid.
struct Grid {
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
  int columns = 2;
  int rows = 2;
  std::vector<double> values;  ///< row by row from y_low upwards

  double x(int column) const { return x_low + (x_high - x_low) * column / (columns - 1); }
  double y(int row) const { return y_low + (y_high - y_low) * row / (rows - 1); }
  double at(int column, int row) const { return values[static_cast<std::size_t>(row * columns + column)]; }
};

/// Where the values are at most `level`.
struct LevelRegion {
  /// Closed paths that cover it; a hole is joined to the outline around it by a cut of no width.
  std::vector<Figure::Path> outlines;
  /// The level lines alone, without the edges of the grid.
  std::vector<Figure::Path> lines;
};

/// By marching squares, with straight lines between neighbouring values.
///
/// source  Lorensen & Cline (1987), Marching cubes, in two dimensions
LevelRegion level_region(const Grid& grid, double level);

}  // namespace shortfall
