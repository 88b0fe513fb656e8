// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/algebra/polynomial.hpp"
#include "analysis/program/tape.hpp"

namespace shortfall {

/// The letters of the rational functions in which symbolic problems compute: n, h, t, k, c, then the
/// integrator's parameters.
inline constexpr Letter kCount = 0;       ///< n, the number of steps
inline constexpr Letter kStepLetter = 1;  ///< h
inline constexpr Letter kTimeLetter = 2;  ///< t
inline constexpr Letter kStiffness = 3;   ///< k, of a spring: a = -k x
inline constexpr Letter kDamping = 4;     ///< c, of a damper: a = -c v
inline constexpr Letter kFirstParameter = 5;

/// What each letter is called for an integrator. The force's k or c is called k_force, c_force when a
/// parameter has its name.
///
/// throws  Unable  when it has more free parameters than there are letters
std::vector<std::string> letter_names(const Tape& tape);

}  // namespace shortfall
