// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/audit/audit.hpp"
#include "analysis/audit/conditions.hpp"

namespace shortfall {

/// A change of a tableau that is tried: entries exchanged, or entries with one unknown (two, for weights)
/// added to them.
struct Trial {
  struct Step {
    Cell cell;
    int times = 1;  ///< so often the unknown is added
  };
  Mend::Kind kind = Mend::Kind::entry;
  std::vector<std::vector<Step>> unknowns;  ///< one list for each unknown; empty: nothing is solved for
  std::vector<std::pair<Cell, Cell>> exchanged;
  bool c_follows = false;  ///< the times are the sums of the rows, whatever these are
  std::string words;       ///< of an exchange
  double cost = 0;         ///< besides that of the slips in single entries

  std::vector<Cell> touched() const;
};

template <class K>
struct Outcome {
  Method<K> mended;
  int checks = 0;  ///< conditions that depend on the change, less the unknowns
};

/// The tableau after a change for which all conditions hold; none when there is no such value.
///
/// Conditions that are linear in the unknown give its value. Of known digits the one that gives most of them
/// is taken.
template <class K>
std::optional<Outcome<K>> outcome(const Trial& trial, const Method<K>& m, const Conditions& conditions);

/// Whether a few conditions show that there is none: cheaper, to be asked first.
template <class K>
bool is_excluded(const Trial& trial, const Method<K>& m, const Conditions& conditions);

}  // namespace shortfall
