// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/audit/program_mends.hpp"
#include "analysis/series/known_digits.hpp"

namespace shortfall {

/// The values of a parameter for which the lowest condition that depends on it holds: of the sums of kicks
/// and of drifts (which have to be 1), then of the order demanded. Empty when one that does not depend on it
/// fails, or none depends on it.
///
/// shape  exact numbers where the program's are; otherwise balls
/// param   printed  its value in the text; others are tried around it, and a polynomial is laid through the
/// defects
std::vector<KnownDigits> values_of_unknown(const Program& program, const std::string& name,
                                           const Rational& printed, int digits, const OrderDemand& demand,
                                           double most_bytes);

}  // namespace shortfall
