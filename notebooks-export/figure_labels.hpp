// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "notebooks-export/figure.hpp"

namespace shortfall {

/// A round number at or above a positive one.
double rounded_up(double value);

/// Names at the ends of curves, moved apart by at least a line.
void place_apart(Figure::Panel& panel, std::vector<Figure::Label> labels);

}  // namespace shortfall
