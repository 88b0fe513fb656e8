// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/correction/jump_flight.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// A jump frame by frame at several frame rates, and the shortfall itself in centimetres, up to the landing
/// of the true motion, a parabola.
///
/// param   flights  without damping and launched by their velocity, of one integrator
/// param   height   H, metres; the launch velocity is sqrt(2 g H)
Figure jump_figure(const std::vector<Flight>& flights, const Rational& height, const Rational& g);

}  // namespace shortfall
