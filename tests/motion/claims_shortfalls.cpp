// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "tests/motion/golden_shortfalls.hpp"

using namespace shortfall;

TEST_CASE("no integrator of the catalogue changes its shortfall under a force of degree 3 unnoticed") {
  const auto golden = testing::golden_shortfalls();
  std::size_t methods = 0;
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;  // what they do is held by recordings
    ++methods;
    CAPTURE(program.name);
    REQUIRE(golden.contains(program.name));
    CHECK(golden.at(program.name).agrees(program));
  }
  CHECK(golden.size() == methods);
}

TEST_CASE("the shortfalls of the catalogue are written anew" * doctest::skip()) {
  std::ofstream out(testing::kShortfallsFile);
  for (const Program& program : catalogue())
    if (family(program) != "engines") out << testing::GoldenShortfall::text(program);
}
