// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/program.hpp"

namespace shortfall {

/// What became of one claim of an `expect` block.
struct ClaimVerdict {
  std::string claim;  ///< as the author wrote it: "shortfall -a*h*t/2"
  bool holds = false;
  std::string found;  ///< what is true instead, in the same words: "shortfall a*h*t/2"
  /// 0: proved. Otherwise coefficients are known to some digits only (approx), and it holds to so many.
  int digits = 0;
  /// Not 0: nothing is proved; it is not contradicted by trees up to this order.
  int trees_up_to = 0;

  bool proved() const { return holds && digits == 0 && trees_up_to == 0; }
};

/// Proves or refutes the claims about forces that are polynomials in time (exact, shortfall,
/// shortfall-velocity), parameters kept as letters. Those about the oscillator: stability_claims.hpp.
///
/// throws  Unable  when there is no closed form to hold them against;  Undefined  when a stage is singular
std::vector<ClaimVerdict> claims(const Program& program);

}  // namespace shortfall
