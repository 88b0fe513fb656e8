// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/unit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

using namespace shortfall;

TEST_CASE("each unit has one name, a size and a dimension") {
  std::set<std::string> seen;
  for (const std::string& name : unit_names()) {
    CAPTURE(name);
    CHECK(seen.insert(name).second);
    const PhysicalUnit* unit = find_unit(name);
    REQUIRE(unit);
    CHECK(unit->scale.sign() > 0);
    const std::vector<std::string> alike = unit_names(unit->dimension);
    CHECK(std::ranges::find(alike, name) != alike.end());
  }
  CHECK(find_unit("parsec") == nullptr);
  CHECK(find_unit("") == nullptr);
  CHECK(find_unit("M") == nullptr);  // capitals count: M is no m
}

TEST_CASE("units of one dimension are in their true ratios") {
  const auto scale = [](const char* name) { return find_unit(name)->scale; };
  CHECK(scale("km") == scale("m") * 1000);
  CHECK(scale("m") == scale("cm") * 100);
  CHECK(scale("cm") == scale("mm") * 10);
  CHECK(scale("mm") == scale("um") * 1000);
  CHECK(scale("year") * 4 == scale("day") * 1461);  // a leap day in four years
  CHECK(scale("day") == scale("h") * 24);
  CHECK(scale("h") == scale("min") * 60);
  CHECK(scale("s") == scale("ns") * 1'000'000'000);
  CHECK(scale("t") == scale("g") * 1'000'000);
  CHECK(scale("fps") == scale("Hz"));
}

TEST_CASE("dimensions multiply, and say what they are") {
  const PhysicalDimension speed = kPhysicalLength * kPhysicalRate;
  CHECK(speed.str() == "L T^-1");
  CHECK((speed * kPhysicalTime) == kPhysicalLength);
  CHECK((kPhysicalMass * speed.pow(2)) == find_unit("J")->dimension);
  CHECK((find_unit("N")->dimension * kPhysicalLength) == find_unit("J")->dimension);
  CHECK(PhysicalDimension{}.str() == "1");
}
