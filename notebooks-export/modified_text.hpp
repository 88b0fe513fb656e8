// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/print.hpp"
#include "analysis/series/hamiltonian.hpp"
#include "analysis/series/modified.hpp"

namespace shortfall {

/// A modified or modifying equation as a person reads it.
std::string as_text(const ModifiedEquation& m, const SeriesSource& source, Style style);
std::string as_text(const ModifiedHamiltonian& h, const SeriesSource& source, Style style);

/// What stands behind v^2/2 + V; in one dimension with equal terms added up.
///
/// param   indent  see SumByPowers::str
std::string hamiltonian_sum(const ModifiedHamiltonian& h, const SeriesSource& source, Style style,
                            const std::string& indent);
std::string one_dimensional_sum(const ModifiedHamiltonian& h, const SeriesSource& source, Style style,
                                const std::string& indent);

}  // namespace shortfall
