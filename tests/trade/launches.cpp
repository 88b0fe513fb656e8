// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/program/catalogue.hpp"
#include "analysis/trade/scene_run.hpp"

using namespace shortfall;

namespace {

const char* const kDriven =
    "until = 2\ndt = 0.1\n[[body]]\nposition = 0.9\nvelocity = 0.4\n[[force]]\nkind = \"expression\"\n"
    "acceleration = \"-x^2 + cos(1.3*t)*(1 + x/2)\"\n[[observable]]\nname = \"x\"\nkind = "
    "\"position\"\ntolerance = 1\n"
    "[[observable]]\nname = \"v\"\nkind = \"velocity\"\ntolerance = 1\n[[observable]]\nname = \"path\"\nkind "
    "= \"path\"\n"
    "count = 4\ntolerance = 1\n";

SceneOutcome outcome(const Scene& scene, const SceneReference& reference, const std::string& name,
                     bool launched, int steps) {
  return SceneStepping(scene, {name, {}, launched, "dd", scene.until / Rational(steps)}).observe(reference);
}

}  // namespace

TEST_CASE("a launch with its read-out raises the measured order to the effective one") {
  const Scene scene = scene_of(kDriven, "driven.toml");
  const SceneReference reference = scene_reference(scene);
  const std::string forces = force_read_by(acceleration_tape(scene));
  CHECK(forces == "a(x, t)");
  int launched = 0;
  for (const char* name : {"symplectic-euler", "symplectic-euler-drift-kick", "velocity-verlet",
                           "explicit-euler", "rk4", "ruth3", "forest-ruth", "pefrl"}) {
    CAPTURE(name);
    const auto launch = launch_for(find_integrator(name), {}, forces);
    if (!launch) continue;
    ++launched;
    double before[3] = {0, 0, 0}, slope[3] = {0, 0, 0};
    for (int steps : {64, 128, 256}) {
      const SceneOutcome o = outcome(scene, reference, name, true, steps);
      REQUIRE(!o.failed);
      for (int i = 0; i < 3; ++i) {
        if (before[i] > 0) slope[i] = std::log2(before[i] / o.errors[static_cast<std::size_t>(i)]);
        before[i] = o.errors[static_cast<std::size_t>(i)];
      }
    }
    // The read-out is needed at every frame that is looked at, not at the last one only.
    for (double s : slope) CHECK(s > launch->effective_order - 0.2);
    CHECK(slope[2] < launch->effective_order + 0.4);
  }
  CHECK(launched >= 2);
}

TEST_CASE("symplectic Euler with its launch is velocity Verlet, frame for frame") {
  const Scene scene = scene_of(kDriven, "driven.toml");
  const SceneReference reference = scene_reference(scene);
  const SceneOutcome a = outcome(scene, reference, "symplectic-euler", true, 50);
  const SceneOutcome b = outcome(scene, reference, "velocity-verlet", false, 50);
  for (std::size_t i = 0; i < 3; ++i) CHECK(a.errors[i] == doctest::Approx(b.errors[i]).epsilon(1e-20));
}

TEST_CASE("compiled steps and interpreted ones have the same bits, in every number of dimensions") {
  for (int d = 1; d <= 3; ++d) {
    std::string x = "0.7", v = "0.3", pull = "\"-x^3 - vx/5\"";
    if (d > 1) x += ", 0.2", v += ", 1.1", pull += ", \"-x*y + cos(t)\"";
    if (d > 2) x += ", -0.4", v += ", 0.2", pull += ", \"-z + y/3\"";
    const Scene scene =
        scene_of("until = 1\ndt = 0.1\ndimension = " + std::to_string(d) + "\n[[body]]\nposition = [" + x +
                     "]\nvelocity = [" + v + "]\n[[force]]\nkind = \"expression\"\nacceleration = [" + pull +
                     "]\n[[observable]]\nkind = \"position\"\ntolerance = 1\n",
                 "bits.toml");
    const SceneReference reference = scene_reference(scene);
    for (const char* name : {"velocity-verlet", "rk4", "implicit-midpoint", "stoermer-verlet"})
      for (const char* format : {"f32", "f64"}) {
        CAPTURE(d);
        CAPTURE(name);
        CAPTURE(format);
        StepChoice choice{name, {}, false, format, Rational(1, 32)};
        const SceneOutcome compiled = SceneStepping(scene, choice).observe(reference);
        choice.interpreted = true;
        const SceneOutcome interpreted = SceneStepping(scene, choice).observe(reference);
        REQUIRE(!compiled.failed);
        CHECK(compiled.errors[0] == interpreted.errors[0]);
        CHECK(compiled.evaluations == interpreted.evaluations);
      }
  }
}
