// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "analysis/algebra/rational.hpp"
#include "analysis/program/program.hpp"
#include "analysis/program/progress.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// An integrator under any force with rational values, for the few frames that this is possible for.
struct ExactFirstFrames {
  std::function<Rational(const Rational& x, const Rational& v, const Rational& t)> force;
  Values parameters;
  int substeps = 1;
  Rational h = Rational(1, 50);
  Rational x0;
  Rational v0;
  int most_frames = 10;                 ///< beyond, somebody has to ask for it
  std::size_t most_digits = 2'000'000;  ///< decimal digits of a number
};

/// Position and velocity at frames 0 to `frames`, in exact arithmetic.
///
/// Under a force that is not linear a step multiplies the digits by its degree (three for a cubic), so that
/// after some ten frames there is no memory for the next: the numbers themselves are so long.
///
/// throws  Unable  beyond most_frames or most_digits; for a step or a stage that has no rational value
std::vector<std::pair<Rational, Rational>> exact_first_frames(const Program& program,
                                                              const ExactFirstFrames& question, int frames,
                                                              const Progress& progress = {});

}  // namespace shortfall
