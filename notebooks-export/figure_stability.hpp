// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/stability/stability.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// The sizes of the eigenvalues against h w, with the stable windows and the limit; for integrators with a
/// stability function also the region |R(z)| <= 1 of the complex plane.
Figure stability_figure(const Stability& stability);

}  // namespace shortfall
