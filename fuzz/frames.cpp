// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of frame lengths.
#include "analysis/algebra/error.hpp"
#include "analysis/motion/frame_list.hpp"
#include "fuzz/target.hpp"

using namespace shortfall;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    parse_frames(text_of(data, size), "fuzz");
  } catch (const Error&) {
  }
  return 0;
}
