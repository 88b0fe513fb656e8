// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/program/print.hpp"
#include "analysis/stability/stability.hpp"

namespace shortfall {

/// Stability as a person reads it: the answer first, then where it comes from.
std::string as_text(const Stability& stability, Style style);

}  // namespace shortfall
