// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "analysis/native/native_run.hpp"

namespace shortfall {

/// How many trajectories are stepped.
enum class NativeLanes {
  where_possible,  ///< side by side in AVX2 registers, where the processor has them
  never,           ///< one after the other
};

/// Whether many trajectories of an integrator are stepped side by side on this processor. Implicit stages are
/// not: each trajectory needs its own number of iterations.
bool has_lanes(const Program& program);

/// Many trajectories of one body on a line, which differ in their start: so many steps of each, with the bits
/// that each would have alone.
///
/// param   force  gets the positions and velocities of some trajectories, and writes their accelerations: it
///                has to treat them alike, number by number
/// param   x, v   the starts; then position and velocity as they are reported after the steps
/// throws  Unable, BadInput  as native_run;  Error  when x and v differ in their number;  Undefined  when a
/// stage
///                           is singular
template <class S>
void native_many(const Program& program, const Values& parameters, S h, ForceReference<S> force,
                 std::span<S> x, std::span<S> v, S t0, std::int64_t steps,
                 NativeLanes lanes = NativeLanes::where_possible);

}  // namespace shortfall
