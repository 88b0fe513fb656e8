// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/series/structure.hpp"

namespace shortfall {

/// Whether a step keeps v^2/2 + V itself, for x'' = -V'(x), per tree: the derivative of the energy along the
/// modified equation vanishes. Refuted at the first order at which it does not.
///
/// Source: Faou, Hairer & Pham (2004), Energy conservation with non-symplectic methods, BIT 44.
Property energy_preserving(const SeriesSource& source, int order);

/// Whether a change of variables makes the step symplectic, per tree: then it keeps a modified energy in the
/// long run as symplectic steps do. Found order by order, c with L_n + [c, F] Hamiltonian, by exact linear
/// algebra.
///
/// Source: Hairer, Lubich & Wanner (2006), VI.8 (conjugate symplecticity).
Property conjugate_symplectic(const SeriesSource& source, int order);

}  // namespace shortfall
