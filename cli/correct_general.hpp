// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.hpp"

namespace shortfall::cli {

/// Whether --force names a class of forces rather than a force: general, a(x, t), ...
bool is_force_class(const std::string& force);

/// `correct` for a force that nobody has chosen: launch and read-out that raise the effective order, with a
/// corrected force when an order is asked for that they do not reach. order 0: as high as launch and read-out
/// go. Returns the exit code.
int correct_general(const Question& q, int order);

}  // namespace shortfall::cli
