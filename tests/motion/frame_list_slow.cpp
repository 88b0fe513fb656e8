// SPDX-License-Identifier: GPL-3.0-or-later
// The limit of frame files: slow under the sanitizers.
#include <doctest/doctest.h>

#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/frame_list.hpp"

namespace shortfall {
namespace {

TEST_CASE("a million frames are read, one more is not") {
  std::string text;
  for (std::size_t n = 0; n < kMostFrames; ++n) text += "1\n";
  CHECK(parse_frames(text, "f").steps.size() == kMostFrames);
  try {
    parse_frames(text + "1\n", "f");
    FAIL("accepted");
  } catch (const SyntaxError& e) {
    CHECK(std::string(e.what()) == "f:1000001:1: there are more than 1,000,000 frames, which is our limit");
  }
}

}  // namespace
}  // namespace shortfall
