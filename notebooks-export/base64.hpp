// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace shortfall {

/// Bytes as text, without line breaks.
///
/// source  RFC 4648 (2006), section 4
std::string base64(const std::string& bytes);

/// The bytes of pairs of hexadecimal digits.
std::string from_hexadecimal(std::string_view digits);

}  // namespace shortfall
