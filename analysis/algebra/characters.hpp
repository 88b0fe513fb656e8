// SPDX-License-Identifier: GPL-3.0-or-later
/// Letters and digits of ASCII, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace shortfall {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_alphabetic(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace shortfall
