// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shortfall {

/// The libraries below the exact arithmetic, by name and by the version that is running.
std::vector<std::pair<std::string, std::string>> arithmetic_libraries();

}  // namespace shortfall
