// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/fraction.hpp"

namespace shortfall {

/// What came of solving for one or two unknowns.
struct Matching {
  std::vector<Letter> unknowns;
  std::optional<std::vector<Fraction>> values;  ///< one for each unknown
  bool impossible = false;                      ///< there is none at all; otherwise we found none
  std::string obstruction;                      ///< why

  /// An expression with the values put in.
  Fraction put_into(Fraction f) const;
};

/// Solves conditions = 0 for one or two unknown letters where they can be eliminated one after the other by
/// linear equations.
Matching matching(const std::vector<Fraction>& conditions, const std::vector<Letter>& unknowns,
                  const std::vector<std::string>& names);

}  // namespace shortfall
