// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/audit/audit.hpp"
#include "analysis/audit/tableau_numbers.hpp"

namespace shortfall {

/// The numbers for which a tableau's decimals probably stand, as one mend. Where all of them are recognised,
/// with square roots at most, they are put in: a claim that they refute shows that they are not meant, and
/// there is no mend; if all claims hold, that is proved.
std::optional<Mend> exact_values(const AuditedTableau& t, const AuditLimits& limits);

}  // namespace shortfall
