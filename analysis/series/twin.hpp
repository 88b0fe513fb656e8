// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/tape.hpp"

namespace shortfall {

/// The integrators of the catalogue that this one is, step by step and for every force a(x, t), when the
/// launch adds `kick` h a(x0, t0) to the velocity and the read-out takes it away again; none when there is no
/// such integrator, or this one is not written out in x and v alone.
///
/// Proved by running both with a force that is nothing but a name: one step makes the same position and
/// velocity, and what the other carries is again what its start makes; the rest is induction.
std::vector<std::string> processed_twins(const Program& program, const Values& given, const Rational& kick);

}  // namespace shortfall
