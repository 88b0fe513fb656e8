// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/series/hamiltonian.hpp"
#include "analysis/series/modified.hpp"
#include "analysis/series/processing.hpp"

namespace shortfall {

/// A coefficient: "p/q" when it is an exact rational, otherwise a formula with a decimal and its digits.
nlohmann::ordered_json number_json(const Fraction& f, const SeriesSource& source);

/// Schema shortfall.modified/1. Formulas are strings; a coefficient is what stands in front of the
/// differential.
nlohmann::ordered_json as_json(const ModifiedEquation& m, const SeriesSource& source);
nlohmann::ordered_json as_json(const ModifiedHamiltonian& h, const SeriesSource& source);

/// One class of forces of shortfall.correct-general/1. A launch is what is added to x0 and v0; a power of h
/// includes the step, so that h^1 a is h a.
nlohmann::ordered_json as_json(const Processing& p, const std::vector<std::string>& twins,
                               const SeriesSource& source);

}  // namespace shortfall
