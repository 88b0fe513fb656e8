// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/motion/claims.hpp"

namespace shortfall {

/// Proves or refutes the claims about the oscillator: trace, determinant, limit. Parameters stay letters in
/// the first two; a limit is about their defaults.
///
/// throws  Unable  when the motion's pair of eigenvalues has no formula of its own
std::vector<ClaimVerdict> stability_claims(const Program& program);

/// Every claim of an integrator, in the order of its file.
std::vector<ClaimVerdict> all_claims(const Program& program);

}  // namespace shortfall
