// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/program/tape.hpp"

namespace shortfall {

/// The same instructions, of which a product and the sum right after it that reads it, as in v + h*a, are
/// marked as one: Run then makes both without waiting for memory between them, which is half the time of a
/// step whose numbers are a processor's own. The product is still stored, so that nothing else changes: the
/// operations, their order and their roundings are the same.
Block quickened(Block block);

}  // namespace shortfall
