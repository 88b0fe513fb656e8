// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/series/splitting_parts.hpp"

namespace shortfall::testing {

/// Both symplectic Eulers, velocity Verlet and position Verlet.
inline const SplittingParts<Rational> kKickDrift{{true, 1}, {false, 1}}, kDriftKick{{false, 1}, {true, 1}},
    kKickDriftKick{{true, Rational(1, 2)}, {false, 1}, {true, Rational(1, 2)}},
    kDriftKickDrift{{false, Rational(1, 2)}, {true, 1}, {false, Rational(1, 2)}};

}  // namespace shortfall::testing
