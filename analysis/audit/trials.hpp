// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/audit/tableau_numbers.hpp"
#include "analysis/audit/trial.hpp"

namespace shortfall {

/// One entry; one number wherever it is written; two entries, two rows, b and bhat, the whole of A exchanged
/// with its transpose.
std::vector<Trial> single_slips(const AuditedTableau& t);

/// What takes more than one slip: an entry of A and the time of its stage; two entries of a row whose sum
/// stays; two weights.
std::vector<Trial> double_slips(const AuditedTableau& t);

}  // namespace shortfall
