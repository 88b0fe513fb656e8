// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/program/print.hpp"
#include "analysis/series/processing.hpp"

namespace shortfall {

/// A launch and a read-out for one class of forces as a person reads them.
///
/// param   twins  integrators that the processed one is, see twin.hpp
std::string as_text(const Processing& p, const std::vector<std::string>& twins, const SeriesSource& source,
                    Style style);

}  // namespace shortfall
