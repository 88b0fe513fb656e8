// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of tests/data/methods say of stability, against what the library proves.
#include <doctest/doctest.h>

#include <filesystem>

#include "analysis/program/tableau_file.hpp"
#include "analysis/stability/stability_function.hpp"

using namespace shortfall;

TEST_CASE("the A-stability and L-stability that the bank's methods claim are proved, or refuted") {
  int proved = 0, refuted = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods")) {
    if (entry.path().extension() != ".json") continue;
    const TableauFile file = parse_tableau_file(entry.path().string());
    CAPTURE(file.name);
    if (!file.claims.a_stable) continue;
    // Decimals stand for other numbers: their R at infinity is small and not 0, and on the imaginary axis |R|
    // may pass 1 by a unit of the last digit. What such files claim is checked with numbers, by
    // tests/independent.
    if (!file.exact()) continue;
    const auto r = stability_function(file.program);
    REQUIRE(r);
    const StabilityProperties properties = stability_properties(*r);
    CHECK(properties.a_stable == file.claims.a_stable->value);
    if (file.claims.l_stable) CHECK(properties.l_stable == file.claims.l_stable->value);
    ++(properties.a_stable ? proved : refuted);
  }
  CHECK(proved >= 20);
  CHECK(refuted >= 40);
}
