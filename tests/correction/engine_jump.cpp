// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps in engines: damping, substeps, impulses, limits. Truth is the engine's loop written out here, and
// values that were computed elsewhere.
#include "analysis/correction/engine_jumps.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/intended_motion.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/correction/engine_loop.hpp"

namespace shortfall {
namespace {

using testing::EngineLoop, testing::kDt, testing::kG;

EngineJump of(const char* engine, const Rational& height, Values values = {}) {
  return engine_jump(find_integrator(engine),
                     {.height = height, .parameters = std::move(values), .binary32_frames = 0});
}

std::string centimetres(const Surd& metres) { return (metres * Surd(100)).decimal(3); }

TEST_CASE("what the usual correction does in each engine: centimetres short at 40 and at 170 cm") {
  struct Row {
    std::vector<const char*> engines;
    Values values;
    const char *low, *low_fixed, *high, *high_fixed;
    Rational per_step;  // the right correction over g dt
  };
  const std::vector<Row> rows{{{"physx", "bullet", "ode", "godot", "cannon-es", "p2", "planck", "box2d-2",
                                "matter-js", "mujoco-euler", "mujoco-implicitfast", "jolt"},
                               {},
                               "2.762",
                               "0.015",
                               "5.727",
                               "0.037",
                               Rational(1, 2)},
                              {{"rapier", "box2d"}, {}, "0.702", "-2.105", "1.460", "-4.352", Rational(1, 8)},
                              {{"jolt"}, {{"N", 4}}, "0.702", "-2.105", "1.460", "-4.352", Rational(1, 8)},
                              {{"chipmunk"}, {}, "-2.841", "-5.784", "-5.824", "-11.710", Rational(-1, 2)},
                              {{"mujoco-rk4"}, {}, "0.015", "-2.841", "0.037", "-5.824", 0}};
  for (const Row& row : rows)
    for (const char* engine : row.engines) {
      CAPTURE(engine);
      const EngineJump low = of(engine, Rational(2, 5), row.values);
      const EngineJump high = of(engine, Rational(17, 10), row.values);
      CHECK(centimetres(low.undamped.shortfall.total) == row.low);
      CHECK(centimetres(low.usual_fix.shortfall) == row.low_fixed);
      CHECK(centimetres(high.undamped.shortfall.total) == row.high);
      CHECK(centimetres(high.usual_fix.shortfall) == row.high_fixed);
      REQUIRE(high.undamped.correction.exists);
      CHECK(high.undamped.correction.value(kG) == row.per_step * kG * kDt);
      CHECK(high.undamped.corrected->exact_at_every_frame);
    }
}

TEST_CASE("Godot with its default damping: 101 cm short of 10 m, 89 cm after the usual correction") {
  const Program godot = find_integrator("godot");
  const Jump j = jump(godot, {.height = 10, .parameters = {{"c", Rational(1, 10)}}});
  CHECK(centimetres(j.shortfall.total).substr(0, 5) == "100.9");
  const Flight flight(godot, kDt, 1, {{"c", Rational(1, 10)}});
  const auto fixed = flight.highest(j.launch_velocity + Surd(kG * kDt / 2), kG);
  CHECK((Surd(10) - fixed.height).decimal(2) == "0.89");
  CHECK(flight.geometric());
  CHECK(flight.rounded().empty());

  // The loop, v *= 1 - c dt; v -= g dt; x += v dt, in exact arithmetic.
  Surd v = j.launch_velocity, x = 0, top = 0;
  Rational best = 0;
  for (int n = 1; n <= 150; ++n) {
    v = v * Surd(Rational(499, 500)) - Surd(kG * kDt);
    x = x + v * Surd(kDt);
    CHECK(flight.height(j.launch_velocity, kG, n) == x);
    if (x > top) {
      top = x;
      best = n;
    }
  }
  CHECK(j.best_frame.n == best);
  CHECK(j.best_frame.height == top);

  // What drag takes, by the closed solution in binary64.
  const double u = std::sqrt(2 * 9.81 * 10), c = 0.1, g = 9.81;
  CHECK(j.shortfall.damping.to_double() == doctest::Approx(10 - (u / c - g / c / c * std::log1p(c * u / g))));
  const double t = best.to_double() * 0.02;
  CHECK(j.shortfall.method.to_double() ==
        doctest::Approx((u + g / c) * -std::expm1(-c * t) / c - g * t / c - top.to_double()));
  CHECK(j.shortfall.total == j.shortfall.damping + j.shortfall.method + j.shortfall.sampling);
  CHECK(j.shortfall.sampling.sign() >= 0);
  CHECK_FALSE(j.correction.exists);

  REQUIRE(j.on_frame);
  v = j.on_frame->launch;
  x = 0;
  top = 0;
  for (int n = 1; n <= 150; ++n) {
    v = v * Surd(Rational(499, 500)) - Surd(kG * kDt);
    x = x + v * Surd(kDt);
    if (x > top) top = x;
  }
  CHECK(top == Surd(10));
}

TEST_CASE("an engine that damps by a power is rounded to 100 digits, and says so") {
  const Program bullet = find_integrator("bullet");
  const Jump j = jump(bullet, {.height = Rational(17, 10), .parameters = {{"c", Rational(1, 10)}}});
  REQUIRE(j.rounded.size() == 1);
  CHECK(j.rounded.front() == "pow(9/10, 1/50)");
  CHECK(j.drag.to_double() == doctest::Approx(-std::log(0.9)));
  const double factor = std::pow(0.9, 0.02);
  double v = j.launch_velocity.to_double(), x = 0, top = 0;
  for (int n = 1; n <= 100; ++n) {
    v = v * factor - 9.81 * 0.02;
    x += v * 0.02;
    top = std::max(top, x);
  }
  CHECK(j.best_frame.height.to_double() == doctest::Approx(top).epsilon(1e-12));
  CHECK(j.on_frame);
  CHECK(jump(bullet, {.height = 1, .binary32_frames = 0}).rounded.empty());
}

TEST_CASE("random damped engines: every frame, the highest one and lift-off are what their loop makes") {
  CHECK(rc::check([] {
    const Rational dt(*rc::gen::inRange(1, 10), *rc::gen::inRange(50, 300));
    const Rational c(*rc::gen::inRange(1, 40), 20);
    const Rational g(*rc::gen::inRange(1, 300), 10), height(*rc::gen::inRange(1, 400), 100);
    const int substeps = *rc::gen::element(1, 2, 5);
    const bool after = *rc::gen::arbitrary<bool>(), divides = *rc::gen::arbitrary<bool>(),
               drift_first = *rc::gen::arbitrary<bool>();
    const std::string factor = divides ? "1/(1 + c*h)" : "max(0, 1 - c*h)";
    const std::string kick = after ? "  v = (v + h*a(x, v, t))*(" + factor + ")\n"
                                   : "  v = v*(" + factor + ")\n  v = v + h*a(x, v, t)\n";
    const std::string drift = "  x = x + h*v\n";
    const Program program = parse(
        "integrator test\n  param c : 1/T = 1\n  assume 1 - c*h > 0\n  solves a(x, v, t) - c*v\nstep\n" +
            (drift_first ? drift + kick : kick + drift),
        "test");
    const Flight flight(program, dt, substeps, {{"c", c}});
    const Rational h = dt / substeps;
    const Rational kept = divides ? 1 / (1 + c * h) : std::max(Rational(0), 1 - c * h);
    const auto heights = [&](const Surd& launch, int count) {
      std::vector<Surd> list{0};
      Surd x = 0, v = launch;
      for (int n = 0; n < count; ++n) {
        for (int k = 0; k < substeps; ++k) {
          if (drift_first) x = x + v * Surd(h);
          v = after ? (v - Surd(g * h)) * Surd(kept) : v * Surd(kept) - Surd(g * h);
          if (!drift_first) x = x + v * Surd(h);
        }
        list.push_back(x);
      }
      return list;
    };
    const Jump j = jump(flight, height, g, 0);
    RC_ASSERT(flight.geometric().has_value());
    std::int64_t frame = 0;
    RC_ASSERT(j.best_frame.n.fits_int64(frame));
    const std::vector<Surd> truth = heights(j.launch_velocity, static_cast<int>(frame) + 12);
    std::size_t best = 0;
    for (std::size_t n = 0; n < truth.size(); ++n) {
      RC_ASSERT(flight.height(j.launch_velocity, g, n) == truth[n]);
      if (truth[n] > truth[best]) best = n;
    }
    RC_ASSERT(j.best_frame.n == Rational(best));
    RC_ASSERT(j.shortfall.total == j.shortfall.damping + j.shortfall.method + j.shortfall.sampling);
    RC_ASSERT(j.shortfall.damping.sign() > 0);
    RC_ASSERT(j.shortfall.sampling.sign() >= 0);
    RC_ASSERT(!j.correction.exists);
    RC_ASSERT(j.lift_off.height.has_value());
    RC_ASSERT((height > *j.lift_off.height) == j.lifts_off);
    RC_ASSERT(j.on_frame.has_value());
    RC_ASSERT(j.on_frame->top.n.fits_int64(frame));
    const std::vector<Surd> aimed = heights(j.on_frame->launch, static_cast<int>(frame) + 12);
    for (std::size_t n = 0; n < aimed.size(); ++n) RC_ASSERT(aimed[n] <= Surd(height));
    RC_ASSERT(aimed[static_cast<std::size_t>(frame)] == Surd(height));
  }));
}

TEST_CASE("kick-first engines with N substeps lift off above (g dt^2/2) ((N + 1)/(2 N))^2") {
  for (const int n : {1, 2, 4, 8, 20})
    CHECK(*lift_off(Flight(find_integrator("rapier"), kDt, 1, {{"N", n}}), kG).height ==
          kG * kDt * kDt / 2 * Rational(n + 1, 2 * n).pow(2));
  CHECK(lift_off(Flight(find_integrator("chipmunk"), kDt), kG).height->is_zero());
  CHECK(*lift_off(Flight(find_integrator("mujoco-rk4"), kDt), kG).height == kG * kDt * kDt / 8);
}

TEST_CASE("PhysX with external forces in every iteration: one engine, two corrections") {
  const Program physx = find_integrator("physx-tgs-external-forces");
  const Jump set = jump(physx, {.height = Rational(17, 10), .binary32_frames = 0});
  REQUIRE(set.correction.exists);
  CHECK(set.correction.value(kG) == kG * kDt / 8);
  const Jump given = jump(physx, {.height = Rational(17, 10), .binary32_frames = 0, .by = LaunchBy::impulse});
  CHECK_FALSE(given.correction.exists);
  CHECK(given.shortfall.total > set.shortfall.total);
  // By hand: N = 4 parts of the impulse, each followed by a drift of dt/4.
  const auto peak = [](const Surd& u) {
    Surd v = 0, x = 0, top = 0;
    for (int n = 0; n < 60; ++n)
      for (int k = 0; k < 4; ++k) {
        v = v - Surd(kG * kDt / 4) + (n == 0 ? u / Surd(4) : Surd(0));
        x = x + v * Surd(kDt / 4);
        if (k == 3 && x > top) top = x;
      }
    return top;
  };
  CHECK(peak(given.launch_velocity) == given.best_frame.height);
  // u = g dt/2 + sqrt(2 g H + (g dt/2)^2 - (g dt/(2 N))^2)
  REQUIRE(given.launch_for_top);
  const Rational half = kG * kDt / 2;
  CHECK(*given.launch_for_top ==
        Surd(half) + Surd::sqrt(2 * kG * Rational(17, 10) + half * half - half * half / 16));
  const Surd missed = Surd(Rational(17, 10)) - peak(*given.launch_for_top);
  CHECK(missed.sign() >= 0);
  CHECK(missed <= Surd(kG * kDt * kDt / 8));
  CHECK_THROWS_AS(
      jump(find_integrator("symplectic-euler"), {.height = 1, .binary32_frames = 0, .by = LaunchBy::impulse}),
      BadInput);
}

TEST_CASE("a limit that acts is reported with its frame, and what becomes of the jump") {
  // At most 2 m a frame: 100 m/s at 50 Hz. 600 m would need 108 m/s.
  const Program box2d = find_integrator("box2d-2");
  const Jump j = jump(box2d, {.height = 600, .binary32_frames = 0});
  REQUIRE(j.limit);
  CHECK(j.limit->frame == 1);
  double v = std::sqrt(2 * 9.81 * 600), x = 0, top = 0;
  for (int n = 1; n < 1000; ++n) {
    v = std::min(v - 9.81 * 0.02, 100.0);
    x += v * 0.02;
    top = std::max(top, x);
  }
  CHECK(j.limit->best_height == doctest::Approx(top));
  CHECK(j.limit->best_height < j.best_frame.height.to_double() - 10);
  CHECK_FALSE(jump(box2d, {.height = 400, .binary32_frames = 0}).limit);
}

TEST_CASE("long damped flights are fast, and their top is the first frame that does not rise") {
  // Falling through honey: c dt is small, the flight long.
  const Program godot = find_integrator("godot");
  const Flight flight(godot, Rational(1, 1000), 1, {{"c", Rational(1, 100)}});
  const Surd launch = 1000;
  const Frame top = flight.highest(launch, kG);
  CHECK(top.n > 50'000);
  CHECK(flight.height(launch, kG, top.n + 1) <= top.height);
  CHECK(flight.height(launch, kG, top.n - 1) < top.height);
}

TEST_CASE("a force held over frame 1 launches like the engine's loop that is given it") {
  const Program engine = find_integrator("physx-tgs-external-forces");
  for (const int n_substeps : {1, 4, 7})
    for (const Rational& c : {Rational(0), Rational(1, 4)}) {
      CAPTURE(n_substeps);
      const Flight flight(engine, kDt, 1, {{"c", c}, {"N", n_substeps}}, LaunchBy::force);
      // Pushed with the acceleration 1/dt during frame 1, without gravity; and in a gravity of 1 alone.
      EngineLoop up{c, n_substeps, true}, down{c, n_substeps, true};
      for (int n = 1; n <= 60; ++n) {
        up.frame(n == 1 ? Rational(1) / kDt : Rational(0));
        down.frame(1);
        REQUIRE(flight.rise(n) == up.x);
        REQUIRE(flight.fall(n) == down.x);
      }
    }
}

TEST_CASE(
    "a held force is a set velocity where the kick comes first and nothing is spread, and less where it is") {
  for (const char* name : {"physx", "bullet", "symplectic-euler"}) {
    CAPTURE(name);
    const Program program = find_integrator(name);
    const Jump held = jump(program, {.height = Rational(17, 10), .by = LaunchBy::force});
    const Jump set = jump(program, {.height = Rational(17, 10)});
    CHECK(held.shortfall.total == set.shortfall.total);
    CHECK(held.correction.exists);
    CHECK(held.correction.per_gravity == set.correction.per_gravity);
    REQUIRE(held.on_frame);
    CHECK(held.on_frame->launch == set.on_frame->launch);
    REQUIRE(held.binary32);
    CHECK(held.binary32->miss.abs() <= 2);
  }
  // Four substeps: in frame 1 the body moves 5/8 of what a set velocity moves it, so no correction serves
  // all.
  const Program rapier = find_integrator("rapier");
  const Jump held = jump(rapier, {.height = Rational(17, 10), .by = LaunchBy::force});
  CHECK_FALSE(held.correction.exists);
  REQUIRE(held.on_frame);
  Rational v = 0, x = 0, top = 0;
  for (int n = 1; n <= 60; ++n) {
    const Rational a = (n == 1 ? held.on_frame->launch / kDt : Rational(0)) - kG;
    for (int s = 0; s < 4; ++s) {
      v += a * kDt / 4;
      x += v * kDt / 4;
    }
    top = std::max(top, x);
  }
  CHECK(top == Rational(17, 10));
  REQUIRE(held.binary32);
  CHECK(held.binary32->miss.abs() <= 2);
}

TEST_CASE("velocity Verlet given a force for one frame ends with the whole velocity, half a frame later") {
  const Flight flight(find_integrator("velocity-verlet"), kDt, 1, {}, LaunchBy::force);
  // a0 of the start is taken before the force is there, so the force acts half in frame 1 and half in
  // frame 2.
  for (int n = 2; n <= 20; ++n) CHECK(flight.rise(n) == kDt * n - kDt);
}

}  // namespace
}  // namespace shortfall
