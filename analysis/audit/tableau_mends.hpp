// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/audit/tableau_claims.hpp"

namespace shortfall {

/// Slips which, undone, let refuted claims hold; the most probable first, then what the claims should say
/// instead.
///
/// One entry that is wrong makes the conditions functions of one unknown. Some of them are linear in it: one
/// gives its value, and all others have to hold for this value as well. So nothing has to be guessed. Entries
/// exchanged are tried, all pairs. Searches are made with fingerprints modulo 2^61 - 1 (or to the digits
/// known); what is found is solved for again with the numbers themselves, and every claim is decided anew.
std::vector<Mend> tableau_mends(const AuditedTableau& t, const TableauFindings& found,
                                const AuditLimits& limits);

}  // namespace shortfall
