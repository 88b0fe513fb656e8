// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace shortfall {

/// What a file holds, but never more than 1 MB and a byte, whatever the file is: enough to see that it is too
/// large.
///
/// throws  UnreadableFile
std::string file_text(const std::string& path);

}  // namespace shortfall
