// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/algebra/polynomial.hpp"

namespace shortfall {

/// The resultant of a and b in one letter: zero exactly where they have a common root there (or both lose
/// their leading terms).
///
/// throws  Undefined  when one of them is zero
Polynomial resultant(const Polynomial& a, const Polynomial& b, Letter letter);

/// The resultant of p and its derivative: zero where p has a multiple root.
Polynomial multiple_root_condition(const Polynomial& p, Letter letter);

}  // namespace shortfall
