// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/correction/jump_flight.hpp"

namespace shortfall {

/// A limit of the integrator that acts before the body is at its top, or a `when` that does not hold: from
/// then on the flight is another one than in closed form.
struct LimitMet {
  std::int64_t frame = 0;  ///< the first such frame, counted from 1
  std::string text;        ///< "limit speed 500"
  /// What becomes of the flight, stepped in binary64 with everything that the integrator does.
  std::int64_t best_frame = 0;
  double best_height = 0;
};

inline constexpr std::int64_t kLimitFrames = 1'000'000;

/// Steps the flight in binary64 up to its top.
///
/// param   top  the highest frame in closed form
/// throws  Unable  when that is beyond kLimitFrames and the integrator has limits
std::optional<LimitMet> limit_met(const Flight& flight, const Surd& launch, const Rational& g,
                                  const Rational& top);

}  // namespace shortfall
