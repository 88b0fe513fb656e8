// SPDX-License-Identifier: GPL-3.0-or-later
// Engines of which there is no recording here, held against loops that do what their source does.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "tests/engines/engine_world.hpp"

namespace shortfall::engines {
namespace {

/// A flight along y: gravity, a constant force, damping.
struct Case {
  double dt, damping, gravity, force, mass, launch, impulse;
};

const std::vector<Case> kCases = {
    {1.0 / 50, 0, -9.81, 0, 1, 5.7, 0},     {1.0 / 60, 0.1, -9.81, 0, 1, 5.7, 0},
    {1.0 / 60, 0.5, -9.81, 2.5, 1, 0.3, 0}, {1.0 / 120, 0.9, -1.62, -7.25, 2, 44.3, 3},
    {1.0 / 30, 0.05, 0, 3.3, 3, 0, -1.7},   {1.0 / 144, 0.01, -9.81, 0, 1, 100, 0},
};
constexpr int kFrames = 400;

struct State {
  double y, v;
  bool operator==(const State&) const = default;
};
using Flight = std::vector<State>;

template <class S, class C>
Flight by_catalogue(const std::string& name, const Case& c, Adding adding) {
  Recording r;
  r.mass = c.mass;
  r.gravity = {0, c.gravity, 0};
  r.force = {0, c.force, 0};
  EngineWorld<S, C> world{r, adding};
  const Tape tape = lower(find_integrator(name), {{"c", Rational::from_double(S(c.damping))}});
  Run<EngineWorld<S, C>> run(tape, world, S(c.dt));
  run.begin(world.vector({0, 0, 0}), world.vector({0, c.launch, 0}), S(0));
  run.give_impulse(world.vector({0, c.impulse / c.mass, 0}));
  Flight flight;
  for (int n = 0; n < kFrames; ++n) {
    run.step();
    const auto [x, v] = run.read_out();
    flight.push_back({double(x.parts()[1]), double(v.parts()[1])});
  }
  return flight;
}

/// Godot's integrate_forces and integrate_velocities, in its real_t, binary32.
Flight godot(const Case& c) {
  Flight flight;
  const float step = float(c.dt), total_damp = float(c.damping);
  float y = 0, v = float(c.launch);
  v = v + float(c.impulse / c.mass);
  for (int n = 0; n < kFrames; ++n) {
    float damp = 1.0F - step * total_damp;
    if (damp < 0) damp = 0;
    v *= damp;
    const float acceleration = float(c.gravity) + float(c.force / c.mass);
    v += acceleration * step;
    y += v * step;
    flight.push_back({y, v});
  }
  return flight;
}

/// p2.js: binary64 numbers, written into Float32Arrays.
Flight p2(const Case& c) {
  Flight flight;
  float y = 0, v = float(c.launch);
  v = float(double(v) + double(float(c.impulse / c.mass)));
  const float total = float(double(float(c.gravity)) + double(float(c.force / c.mass)));
  for (int n = 0; n < kFrames; ++n) {
    v = float(double(v) * std::pow(1.0 - c.damping, c.dt));
    v = float(double(v) + double(float(double(total) * c.dt)));
    y = float(double(y) + double(float(double(v) * c.dt)));
    flight.push_back({y, v});
  }
  return flight;
}

/// mj_RungeKutta with N = 4: stages from A, their weighted sum from B, the applied force held.
Flight mujoco_rk4(const Case& c) {
  constexpr std::array<double, 3> kA = {0.5, 0.5, 1};
  constexpr std::array<double, 4> kB = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  Flight flight;
  double y = 0, v = c.launch + c.impulse / c.mass;
  const double force = c.gravity + c.force / c.mass;
  for (int n = 0; n < kFrames; ++n) {
    std::array<double, 4> stage_v{}, stage_a{};
    for (std::size_t i = 0; i < 4; ++i) {
      stage_v[i] = i == 0 ? v : v + c.dt * (kA[i - 1] * stage_a[i - 1]);
      stage_a[i] = force - c.damping * stage_v[i];
    }
    double dy = 0, dv = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      dy += kB[i] * stage_v[i];
      dv += kB[i] * stage_a[i];
    }
    y += c.dt * dy;
    v += c.dt * dv;
    flight.push_back({y, v});
  }
  return flight;
}

/// mj_implicit on a body without rotation: (M + h D) dv = h (forces - D v), solved by Gauss.
Flight mujoco_implicit(const Case& c) {
  Flight flight;
  double y = 0, v = c.launch + c.impulse / c.mass;
  for (int n = 0; n < kFrames; ++n) {
    const double damping = c.mass * c.damping;
    const double smooth = c.mass * c.gravity + c.force - damping * v;
    v += c.dt * (smooth / (c.mass + c.dt * damping));
    y += c.dt * v;
    flight.push_back({y, v});
  }
  return flight;
}

TEST_CASE("Godot's frame is what its source does, to the last bit") {
  for (const Case& c : kCases) {
    CAPTURE(c.dt);
    CHECK(by_catalogue<float, float>("godot", c, Adding::at_once) == godot(c));
  }
}

TEST_CASE("p2's frame is what its source does, to the last bit of its binary32 arrays") {
  for (const Case& c : kCases) {
    CAPTURE(c.dt);
    CHECK(by_catalogue<double, float>("p2", c, Adding::at_once) == p2(c));
  }
}

TEST_CASE("MuJoCo's RK4 frame is what its source does, to the last bit") {
  for (const Case& c : kCases) {
    CAPTURE(c.dt);
    CHECK(by_catalogue<double, double>("mujoco-rk4", c, Adding::at_once) == mujoco_rk4(c));
  }
}

TEST_CASE(
    "MuJoCo's implicit integrator does to a body without rotation what implicitfast does, to rounding") {
  for (const Case& c : kCases) {
    const Flight ours = by_catalogue<double, double>("mujoco-implicitfast", c, Adding::at_once);
    const Flight theirs = mujoco_implicit(c);
    for (std::size_t n = 0; n < ours.size(); ++n) {
      CHECK(ours[n].y == doctest::Approx(theirs[n].y).epsilon(1e-12));
      CHECK(ours[n].v == doctest::Approx(theirs[n].v).epsilon(1e-12));
    }
  }
}

TEST_CASE("damping that would turn the velocity round stops at zero in Godot") {
  const Case c{1.0 / 10, 30, 0, 0, 1, 4, 0};
  const Flight flight = by_catalogue<float, float>("godot", c, Adding::at_once);
  CHECK(flight == godot(c));
  CHECK(flight.front() == State{0, 0});
}

}  // namespace
}  // namespace shortfall::engines
