// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/correction/matching.hpp"

namespace shortfall {

/// For each unknown of an algebraic matching, the first term in which it differs from the true value as a
/// power series in h: coefficient times h^p, 0 when there is none up to h^8.
///
/// shape   one for each unknown; empty when the equations contain further letters
std::vector<Fraction> leading_differences(const Matching& m, const BranchPoint& point, const Fraction& k,
                                          const Fraction& c);

}  // namespace shortfall
