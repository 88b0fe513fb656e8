// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/audit/tableau_numbers.hpp"

namespace shortfall {

/// A number as it would stand in a place of the file, in the manner of what is printed there.
std::string written(const AuditedTableau& t, const Cell& cell, const Rational& value);
std::string written(const AuditedTableau& t, const Cell& cell, const Fraction& value);
std::string written(const AuditedTableau& t, const Cell& cell, const KnownDigits& value);

/// A number known to some digits in the manner of what is printed: a fraction with the same numerator or
/// denominator, a decimal that a single slip makes of it, a simple fraction, or as many digits as are known.
std::string written_like(const KnownDigits& value, const std::string& printed);

}  // namespace shortfall
