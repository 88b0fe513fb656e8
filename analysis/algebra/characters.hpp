// SPDX-License-Identifier: GPL-3.0-or-later
/// Letters and digits of ASCII, whatever the locale.
#pragma once

namespace shortfall {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_alphabetic(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace shortfall
