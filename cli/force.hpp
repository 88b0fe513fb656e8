// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall::cli {

/// The degree of the force polynomial that `--force` names, for commands that answer for such forces only:
/// constant is 0, poly:D is D.
///
/// throws  BadInput  for an unknown force, with a suggestion; Unable for a linear force
int force_degree(const std::string& text);

}  // namespace shortfall::cli
