// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace shortfall {

/// Bytes of the UTF-8 character that begins at i < text.size(); 0 when there is none that is well formed.
///
/// source  RFC 3629 (2003), UTF-8, section 4; overlong forms of three and four bytes and surrogates pass
std::size_t utf8_length(std::string_view text, std::size_t i);

/// Whether a byte goes on with a character that has begun.
constexpr bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace shortfall
