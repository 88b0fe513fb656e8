// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// How one text can have become another by a slip of the pen.
struct Slip {
  std::string words;  ///< "two digits change places"
  double cost = 0;    ///< 1 for a single digit or sign, more for what is less likely
};

/// The slip that turns `right` into `printed`.
Slip slip(const std::string& printed, const std::string& right);

/// Every text from which a single slip leads to this one: a sign turned, put or left out, a digit replaced,
/// put, left out, or exchanged with its neighbour.
std::vector<std::string> before_a_slip(const std::string& printed);

/// How a rational number may be written, in the manner of what was printed: in lowest terms, with the same
/// denominator or numerator, as a decimal. The most likely first.
std::string written_like(const Rational& value, const std::string& printed);

/// The number of characters inserted, left out, replaced, or exchanged with their neighbours.
///
/// source  Damerau (1964), A technique for computer detection and correction of spelling errors
int edit_distance(const std::string& a, const std::string& b);

}  // namespace shortfall
