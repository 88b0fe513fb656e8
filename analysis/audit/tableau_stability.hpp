// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "analysis/audit/tableau_numbers.hpp"

namespace shortfall {

/// What is known of R(z) for Re z <= 0.
struct TableauStability {
  bool a_stable = false;
  bool l_stable = false;
  std::string why;  ///< it is not A-stable, or not L-stable
  int digits = 0;   ///< 0: proved
};

/// Proved where the numbers are exact. Decimals leave a small number where R has a zero at infinity, and pass
/// 1 on the imaginary axis by a unit of the last digit: what is nothing to the digits printed is taken as 0,
/// and the answer holds to those digits.
///
/// none  for Nystroem tableaus;  throws  Undefined, Unable
std::optional<TableauStability> tableau_stability(const AuditedTableau& t);

}  // namespace shortfall
