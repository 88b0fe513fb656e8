// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall::cli {

/// The degree of the force polynomial that `--force` names: constant is 0, poly:D is D.
///
/// throws  BadInput  for an unknown force, with a suggestion
int force_degree(const std::string& text);

}  // namespace shortfall::cli
