// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/utf8.hpp"

namespace shortfall {

std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!continues_utf8(text[i + k])) return 0;
  return length;
}

}  // namespace shortfall
