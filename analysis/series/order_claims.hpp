// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/motion/claims.hpp"

namespace shortfall {

/// Whether a claim is one of those about every smooth force: order, embedded-order, symplectic, symmetric.
bool about_series(const Claim& claim);

/// Proves or refutes them. What is true up to an order of trees only counts as holding, and `found` says so.
std::vector<ClaimVerdict> order_claims(const Program& program);

}  // namespace shortfall
