// SPDX-License-Identifier: GPL-3.0-or-later
// `identify` before recordings of real engines.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include "tests/engines/confusion.hpp"

namespace shortfall::engines {
namespace {

void check_every(std::size_t stride, const Blur& blur) {
  const std::string folder = SHORTFALL_SOURCE_DIR "/tests/data/recordings";
  const std::vector<Recording> all = recordings(folder);
  for (std::size_t i = 0; i < all.size(); i += stride) {
    std::ifstream in(folder + "/" + all[i].file, std::ios::binary);
    const Verdict v = verdict(all[i], std::string(std::istreambuf_iterator<char>(in), {}), blur);
    CAPTURE(v.file);
    CAPTURE(v.answer);
    CHECK(v.kind != Verdict::Kind::wrong);
    // A body that falls asleep half a second after its launch has hardly been seen to move.
    if (v.file.find("sleep") == std::string::npos) CHECK(v.kind != Verdict::Kind::missed);
    CHECK(v.unfaithful == 0);
  }
}

TEST_CASE("a recording's engine is among the maps that are listed for it") { check_every(6, {}); }

TEST_CASE("so it is when the numbers are rounded to a tenth of a millimetre, without velocities" *
          doctest::test_suite("thorough")) {
  check_every(12, {4, false});
}

}  // namespace
}  // namespace shortfall::engines
