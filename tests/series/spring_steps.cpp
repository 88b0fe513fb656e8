// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "tests/series/golden_spring.hpp"

using namespace shortfall;

TEST_CASE(
    "steps of a damped, driven spring are those of the second implementation, for the whole catalogue") {
  const auto golden = testing::golden_spring_steps();
  int compared = 0;
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;  // held by recordings
    CAPTURE(program.name);
    REQUIRE(golden.contains(program.name));
    CHECK(golden.at(program.name).agrees(program));
    ++compared;
  }
  CHECK(compared == static_cast<int>(golden.size()));
  CHECK_FALSE(golden.at("rk4").agrees(find_integrator("kutta3")));
}
