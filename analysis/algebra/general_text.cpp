// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/general_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace shortfall {

std::string general_text(double value, int digits) {
  std::array<char, 400> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
  std::string result(text.data(), end);
  // libstdc++ 12 keeps zeros behind the point of whole numbers, "120.000", which %g does not.
  const std::size_t mantissa = std::min(result.find('e'), result.size());
  if (result.find('.') < mantissa) {
    std::size_t kept = result.find_last_not_of('0', mantissa - 1) + 1;
    if (result[kept - 1] == '.') --kept;
    result.erase(kept, mantissa - kept);
  }
  return result;
}

double double_of(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const bool bits = text.starts_with("0x");
  if (bits) text.remove_prefix(2);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value,
                  bits ? std::chars_format::hex : std::chars_format::general);
  return negative ? -value : value;
}

}  // namespace shortfall
