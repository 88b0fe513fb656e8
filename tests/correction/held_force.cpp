// SPDX-License-Identifier: GPL-3.0-or-later
// A force that is held over several frames and launches: against loops that are given it, in exact
// arithmetic.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/correction/engine_loop.hpp"

namespace shortfall {
namespace {

using testing::EngineLoop, testing::kDt, testing::kG;

/// launch, held over `frames`, in gravity.
Rational height(EngineLoop loop, const Rational& launch, int frames, int n) {
  for (int k = 1; k <= n; ++k) loop.frame((k <= frames ? launch / (kDt * frames) : Rational(0)) - kG);
  return loop.x;
}

Flight flight_of(const EngineLoop& loop, int frames) {
  return Flight(find_integrator(loop.damps_first ? "physx-tgs-external-forces" : "rapier"), kDt, 1,
                {{"c", loop.c}, {"N", loop.substeps}}, LaunchBy::force, frames);
}

TEST_CASE(
    "a force that is held over any number of frames lifts a body like the engine's loop that is given it") {
  CHECK(rc::check([] {
    const EngineLoop loop{Rational(*rc::gen::inRange(0, 3), 4), *rc::gen::inRange(1, 6),
                          *rc::gen::arbitrary<bool>()};
    const int frames = *rc::gen::inRange(1, 40);
    const Flight flight = flight_of(loop, frames);
    const Rational launch(*rc::gen::inRange(1, 400), 7);
    // While the force acts, when it ends, and long after, where only the closed form answers.
    for (const int n : {1, frames - 1, frames, frames + 1, frames + 2, frames + 30, 200})
      if (n >= 0) RC_ASSERT(flight.height(Surd(launch), kG, n) == Surd(height(loop, launch, frames, n)));
    RC_ASSERT(flight.parabolic() || flight.geometric());
  }));
}

TEST_CASE("the force that takes a frame to the height takes no frame higher") {
  for (const Rational& c : {Rational(0), Rational(1, 2)})
    for (const int frames : {1, 2, 5, 12, 25})
      for (const int substeps : {1, 4}) {
        CAPTURE(frames);
        CAPTURE(substeps);
        const EngineLoop loop{c, substeps, false};
        const Jump held = jump(find_integrator("rapier"), {.height = Rational(17, 10),
                                                           .parameters = {{"c", c}, {"N", substeps}},
                                                           .binary32_frames = 0,
                                                           .by = LaunchBy::force,
                                                           .force_frames = frames});
        REQUIRE(held.on_frame);
        const Rational launch = held.on_frame->launch;
        std::int64_t top = 0;
        REQUIRE(held.on_frame->top.n.fits_int64(top));
        CHECK(height(loop, launch, frames, static_cast<int>(top)) == Rational(17, 10));
        for (int n = 1; n <= 120; ++n) CHECK(height(loop, launch, frames, n) <= Rational(17, 10));
        CHECK(held.force_of(Surd(launch)) == Surd(launch / (kDt * frames)));
        // What is compared: the launch of the exact motion, and its highest frame.
        Surd best;
        for (int n = 0; n <= 120; ++n) {
          const EngineLoop free{c, substeps, false};
          // Heights are affine in the launch.
          const Rational fall = height(free, 0, frames, n), rise = height(free, 1, frames, n) - fall;
          best = std::max(best, held.launch_velocity * rise + Surd(fall));
        }
        CHECK(best == held.best_frame.height);
      }
}

TEST_CASE("the force that takes the exact motion to the height does so: it rises under it, then freely") {
  for (const int frames : {1, 4, 30}) {
    const Jump held = jump(
        find_integrator("physx"),
        {.height = Rational(17, 10), .binary32_frames = 0, .by = LaunchBy::force, .force_frames = frames});
    REQUIRE(held.exact_force_launch);
    const Surd t(kDt * frames), g(kG), a = held.force_of(*held.exact_force_launch) - g, v = a * t;
    CHECK(a * t * t / Surd(2) + v * v / (Surd(2) * g) == Surd(Rational(17, 10)));
  }
  CHECK_FALSE(jump(find_integrator("godot"), {.height = 1, .binary32_frames = 0, .by = LaunchBy::force})
                  .exact_force_launch);
}

TEST_CASE("a force that is too weak does not lift the body, and one frame is what it was") {
  // sqrt(2 g H)/(N dt) < g.
  const Jump weak =
      jump(find_integrator("physx"),
           {.height = Rational(1, 10), .binary32_frames = 0, .by = LaunchBy::force, .force_frames = 30});
  CHECK_FALSE(weak.lifts_off);
  CHECK_FALSE(weak.parabola_top);
  REQUIRE(weak.on_frame);
  const Program verlet = find_integrator("velocity-verlet");
  const Flight once(verlet, kDt, 1, {}, LaunchBy::force), same(verlet, kDt, 1, {}, LaunchBy::force, 1);
  for (int n = 0; n < 9; ++n) CHECK(once.rise(n) == same.rise(n));
  for (const int frames : {0, -1, Flight::kForceFrames + 1})
    CHECK_THROWS_AS(Flight(verlet, kDt, 1, {}, LaunchBy::force, frames), BadInput);
}

TEST_CASE("velocity Verlet given a force for some frames ends with the whole velocity") {
  for (const int frames : {1, 3, 20}) {
    const Flight flight(find_integrator("velocity-verlet"), kDt, 1, {}, LaunchBy::force, frames);
    for (int n = frames + 1; n <= 60; ++n) CHECK(flight.rise(n + 1) - flight.rise(n) == kDt);
  }
}

}  // namespace
}  // namespace shortfall
