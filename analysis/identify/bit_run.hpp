// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "analysis/identify/candidate.hpp"
#include "analysis/identify/components.hpp"
#include "analysis/identify/fit.hpp"
#include "analysis/identify/observations.hpp"

namespace shortfall {

/// What an engine computes in, and what it stores.
enum class Arithmetic {
  binary32,
  binary64,
  binary64_stored_32,
};

/// One body in space and everything that is known about it.
struct EngineFlight {
  using Triple = Log::Triple;

  Triple x0{}, v0{};
  Triple gravity{};
  Triple force{};  ///< a constant one, over the mass
  double k = 0;    ///< of a spring, over the mass
  Triple rest{};   ///< where it does not pull
  double c = 0;    ///< damping number
  Launch launch = Launch::velocity;
  Triple impulse{};  ///< over the mass
  Adding adding = Adding::at_once;
  Arithmetic arithmetic = Arithmetic::binary64;
};

/// What came out when a map was run beside a log in the arithmetic of an engine.
struct Comparison {
  std::size_t same = 0;  ///< rows from the first on that agree to the last bit
  bool exact = false;    ///< all of them
  double ulp = 0;  ///< the largest difference, in units in the last place of the largest number of its column
  double worst_position = 0, worst_velocity = 0;
};

/// param   only   compares one axis; -1 for all
/// param   whole  false: stops at the first row that differs
/// throws  Unable  for an integrator with implicit stages
Comparison compare(const Candidate& candidate, const Observations& observations, const EngineFlight& flight,
                   int only = -1, bool whole = true);

/// The rows of a flight, positions and velocities; those of the observations' frames.
void fly(const Candidate& candidate, const std::vector<std::size_t>& frames, double dt,
         const EngineFlight& flight,
         const std::function<bool(std::size_t row, const Log::Triple& x, const Log::Triple& v)>& see);

}  // namespace shortfall
