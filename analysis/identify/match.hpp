// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/identify/identification.hpp"
#include "analysis/identify/observations.hpp"

namespace shortfall {

/// What is known before a log is looked at.
struct Known {
  std::optional<double> g;
  int up = 1;
};

/// One candidate beside the rows: fitted; where they hold all bits, run in the arithmetic of engines with the
/// simplest numbers that the fit allows.
std::optional<Match> match(const Candidate& candidate, const Observations& observations,
                           const FitQuestion& question, const Known& known);

/// The simplest rational number within a distance: the one with the least denominator.
Rational simplest(double value, double distance);

}  // namespace shortfall
