// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall::cli {

/// `shortfall --version --json`: the version, and what this program was built with and runs on.
std::string version_json();

}  // namespace shortfall::cli
