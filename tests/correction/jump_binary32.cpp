// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/undamped_catalogue.hpp"

namespace shortfall {
namespace {

/// A game's own loop: kick, then drift, all in binary32.
float top_of_loop(float launch, float dt, float g) {
  float x = 0, v = launch, top = 0;
  for (int n = 0; n < 100'000; ++n) {
    const float kick = dt * -g;
    v = v + kick;
    const float drift = dt * v;
    x = x + drift;
    if (x < top) break;
    top = x;
  }
  return top;
}

Jump jump_to(const Rational& height, int substeps = 1, const char* integrator = "symplectic-euler") {
  return jump(find_integrator(integrator), {.height = height, .substeps = substeps});
}

TEST_CASE("in binary32 the jumps to 0.4 m and 1.7 m miss by one unit in the last place at most") {
  for (const char* height : {"0.4", "1.7"}) {
    const Jump j = jump_to(Rational::parse(height));
    REQUIRE(j.binary32);
    CHECK(j.binary32->miss.abs() <= 1);
    CHECK(j.binary32->top == top_of_loop(j.binary32->launch, 0.02F, 9.81F));
    CHECK(j.binary32->n == (std::string(height) == "0.4" ? 14 : 29));
  }
  CHECK(jump_to(Rational(2, 5)).binary32->miss.is_zero());
  CHECK(jump_to(Rational(2, 5)).binary32->top == 0.4F);
}

TEST_CASE("what the search finds is what a game's loop does, and no launch among many neighbours is better") {
  CHECK(rc::check([] {
    const Rational height(*rc::gen::inRange(1, 100'000), 1000);
    const Jump j = jump_to(height);
    RC_ASSERT(j.binary32.has_value());
    const Binary32Launch& found = *j.binary32;
    RC_ASSERT(found.top == top_of_loop(found.launch, found.dt, found.g));
    RC_ASSERT(found.shortfall == height - Rational::from_double(found.top));
    const auto miss = [&](float top) {
      return std::abs(static_cast<double>(top) - static_cast<double>(found.target));
    };
    float beside = found.launch;
    for (int k = 0; k < 50; ++k) beside = std::nextafter(beside, 0.0F);
    for (int k = 0; k < 101; ++k, beside = std::nextafter(beside, 1e30F))
      RC_ASSERT(miss(top_of_loop(beside, found.dt, found.g)) >= miss(found.top));
  }));
}

TEST_CASE(
    "of a thousand targets about half are hit to the last bit, and the rest within 2 units in the last "
    "place") {
  int hits = 0, worst_hits = 0;
  const Flight flight(find_integrator("symplectic-euler"), Rational(1, 50));
  for (int i = 1; i <= 1000; ++i) {
    const Jump j = jump(flight, Rational(i, 500), Rational(981, 100));
    REQUIRE(j.binary32);
    hits += j.binary32->miss.is_zero();
    worst_hits += j.binary32->miss.abs() > 2;
  }
  MESSAGE("hit to the last bit: " << hits << " of 1000; more than 2 units off: " << worst_hits);
  CHECK(hits > 350);
  CHECK(hits < 650);
  CHECK(worst_hits < 20);
}

TEST_CASE(
    "every integrator of the catalogue has a binary32 launch that is 3 units in the last place off at most") {
  for (const Program& program : testing::short_catalogue()) {
    CAPTURE(program.name);
    const Jump j = jump(program, {.height = Rational(17, 10)});
    REQUIRE_MESSAGE(j.binary32, j.no_binary32);
    CHECK(j.binary32->miss.abs() <= 3);
  }
}

TEST_CASE("a search that would take too long is refused, and so are numbers that binary32 does not have") {
  const Jump high = jump_to(1'000'000'000);
  CHECK_FALSE(high.binary32);
  CHECK(high.no_binary32.find("the limit is 10000000") != std::string::npos);
  const Jump coarse = jump(find_integrator("symplectic-euler"),
                           {.height = Rational::parse("1e-9"), .dt = Rational::parse("1e-50")});
  CHECK_FALSE(coarse.binary32);
  CHECK(coarse.no_binary32 == "the time step is out of the range of binary32");
}

}  // namespace
}  // namespace shortfall
