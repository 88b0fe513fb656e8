// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/correction/open_step.hpp"

namespace shortfall {

/// A step whose entries are letters: formulas that are solved from it stay short, whatever the entries are.
struct LetteredStep {
  struct Meaning {
    std::string name;  ///< "m11", ..., "xr", "vr"
    Fraction value;    ///< in the letters of the step itself
    std::string note;
  };
  OpenStep step;
  std::vector<std::string> names;  ///< of its letters
  std::vector<Meaning> meanings;
};

/// For a spring, without a force or with a constant one, where the integrator carries position and velocity
/// and nothing else; none for others.
///
/// param   names  of the letters of a kit
std::optional<LetteredStep> lettered(const OpenStep& step, const std::vector<std::string>& names);

}  // namespace shortfall
