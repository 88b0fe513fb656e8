// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/trade/portrait.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// Left the plane of position and velocity: states as dots on the level lines of the true energy and of the
/// modified one. Right how far both energies are from where they began.
Figure portrait_figure(const Portrait& portrait, EnergySurfaces surfaces);

}  // namespace shortfall
