// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/algebra/rational.hpp"
#include "analysis/correction/jump_flight.hpp"

namespace shortfall {

inline constexpr std::int64_t kBinary32Frames = 10'000'000;

/// A launch stored in binary32 and what the integrator makes of it in binary32: dt, g and the parameters are
/// rounded once, as a game stores them, then every operation is.
struct Binary32Launch {
  float launch = 0;
  float target = 0;  ///< the binary32 nearest to H
  float top = 0;     ///< height of the highest frame
  std::int64_t n = 0;
  Rational miss;       ///< top - target in units in the last place of the target; positive: too high
  Rational shortfall;  ///< H - top, metres
  float dt = 0;
  float g = 0;
  int launches = 0;         ///< how many were tried
  std::int64_t frames = 0;  ///< how many were stepped
};

/// The best of the neighbouring floats, or why there is none.
struct Binary32Search {
  std::optional<Binary32Launch> best;
  std::string reason;
};

/// From a launch and the frame of its top, both exact: brackets the target between neighbouring floats and
/// looks at some more on each side.
///
/// param   most  frames to step before giving up
Binary32Search binary32_launch(const Flight& flight, const Rational& height, const Rational& g,
                               const Rational& launch, const Rational& frame, std::int64_t most);

}  // namespace shortfall
