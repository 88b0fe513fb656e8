// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/correction/kit.hpp"
#include "analysis/motion/derivation.hpp"

namespace shortfall {

/// A derivation as LaTeX (amsmath) for the middle of a document: the shortfall, the lines with their reasons,
/// the corrections, first as a table (booktabs).
std::string as_latex(const Derivation& derivation, const CorrectionKit* kit);

/// Text that LaTeX sets as it stands.
std::string latex_escaped(const std::string& text);

}  // namespace shortfall
