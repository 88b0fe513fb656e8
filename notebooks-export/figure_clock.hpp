// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/floating/clock.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// A float clock: what it has lost or gained by the time asked for, and how fast it goes, binade by binade.
///
/// throws  Unable  for fewer than two additions, or a clock that stands still from the first on
Figure clock_figure(const ClockReport& report);

}  // namespace shortfall
