// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/identify/identification.hpp"
#include "notebooks-export/figure.hpp"

namespace shortfall {

/// What maps leave unexplained of a log, frame by frame: above those that reproduce it, one of each group,
/// below the nearest that are refuted, each panel with its own scale.
///
/// throws  Unable  when no map was held against the log
Figure residual_figure(const Log& log, const Identification& found);

}  // namespace shortfall
