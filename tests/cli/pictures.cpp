// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that commands draw, where gnuplot is here.
#include <doctest/doctest.h>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE("clock --plot draws what is lost and how fast it goes; --kahan and other endings are refused") {
  const Folder folder;
  const CommandRun drawn = folder.run("clock --dt 1/60f --until 24h --plot clock.svg");
  if (drawn.code == 5) {  // gnuplot is not here
    CHECK(contains(drawn.error, "gnuplot"));
  } else {
    CHECK(drawn.code == 0);
    CHECK(contains(folder.text("clock.svg"), "speed off by (ppm)"));
  }
  CHECK(folder.run("clock --dt 1/60f --until 24h --plot clock.bmp").code == 2);
  CHECK(folder.run("clock --dt 1/60f --until 24h --kahan --plot kahan.svg").code == 2);
  CHECK_FALSE(folder.has("kahan.svg"));
}

}  // namespace
}  // namespace shortfall
