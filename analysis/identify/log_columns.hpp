// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/algebra/rational.hpp"

namespace shortfall {

/// What the columns of a log hold: places of the nine things that are read, -1 for none.
struct LogColumns {
  enum Thing { frame, time, body, x, y, z, vx, vy, vz, things };
  std::vector<int> place = std::vector<int>(things, -1);
  std::string unit = "m";  ///< of lengths
  Rational metres = 1;     ///< of one such unit
  Rational seconds = 1;    ///< of one unit of the time stamps

  bool has(Thing t) const { return place[t] >= 0; }
  bool positions() const { return has(x) || has(y) || has(z); }
  bool velocities() const;  ///< one for each axis that has a position
};

/// The columns that a header names.
///
/// param   asked  what the user says: "x" is the column "posX"
/// throws  BadInput  when a column that was asked for is missing, or a thing is named twice
LogColumns columns_of_header(const std::vector<std::string>& header,
                             const std::map<std::string, std::string>& asked);

/// The columns of rows without a header: by how many there are, and whether the first ones count frames or
/// tell the time.
///
/// throws  BadInput  when that says nothing
LogColumns columns_without_header(const std::vector<std::vector<std::string>>& rows);

}  // namespace shortfall
