// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/series/order.hpp"
#include "analysis/trade/scene_run.hpp"

using namespace shortfall;

namespace {

struct Measured {
  const char* name;
  const char* forces;  ///< the class that holds the force
  const char* scene;
};

const std::string kBoth =
    "[[observable]]\nname = \"x\"\nkind = \"position\"\ntolerance = 1\n[[observable]]\nname = \"v\"\nkind = "
    "\"velocity\"\n"
    "tolerance = 1\n";

// One scene for each thing that a force can read, none of them linear: a linear one shows too much.
const Measured kScenes[] = {
    {"Kepler", "a(x)",
     "dimension = 2\nuntil = 1\ndt = 1/10\n[[body]]\nposition = [0.7, 0.1]\nvelocity = [0.2, "
     "1.3]\n[[force]]\n"
     "kind = \"kepler\"\nmu = 1\n"},
    {"anharmonic", "a(x)",
     "until = 1\ndt = 1/10\n[[body]]\nposition = 1.1\nvelocity = 0.4\n[[force]]\nkind = \"potential\"\n"
     "potential = \"x^2/2 + x^4/3 + x^3/5\"\n"},
    {"driven", "a(x, t)",
     "until = 1\ndt = 1/10\n[[body]]\nposition = 0.9\nvelocity = 0.4\n[[force]]\nkind = \"expression\"\n"
     "acceleration = \"-x^2 + cos(1.3*t)*(1 + x/2) + t/3\"\n"},
    {"velocity-dependent", "a(x, v, t)",
     "until = 1\ndt = 1/10\n[[body]]\nposition = 0.9\nvelocity = 0.6\n[[force]]\nkind = \"expression\"\n"
     "acceleration = \"-x - x^3 - vx^2*(1 + x/3)/2 + sin(t)*vx\"\n"},
};

Scene scene_of_sample(const Measured& m) {
  std::string text = m.scene + kBoth;
  text.replace(text.find("dt = 1/10"), 9, "dt = 0.1");
  return scene_of(text, std::string(m.name) + ".toml");
}

/// The larger of the errors of x and v.
double error(const Scene& scene, const SceneReference& reference, const std::string& integrator, int steps) {
  const StepChoice choice{integrator, {}, false, "dd", Rational(1, steps)};
  const SceneOutcome o = SceneStepping(scene, choice).observe(reference);
  REQUIRE_MESSAGE(!o.failed, o.why);
  return std::max(o.errors[0], o.errors[1]);
}

}  // namespace

TEST_CASE("orders that are measured are those that are proved, for the whole catalogue") {
  std::map<std::string, SceneReference> references;
  int measured = 0;
  for (const Program& program : catalogue()) {
    // An engine's damping is part of another equation than the scene's.
    if (program.solves || program.holds_force || program.impulse) continue;
    for (const Measured& m : kScenes) {
      CAPTURE(program.name);
      CAPTURE(std::string(m.name));
      int proved = 0;
      try {
        const SeriesSource source(program, {});
        const OrderOfClass found = order_of_class(source, force_class(m.forces), OrderLimits{10});
        REQUIRE(!found.at_least);
        proved = found.order;
      } catch (const Unable&) {
        continue;  // no series: a limit, or a function of h
      }
      if (proved == 0) continue;  // no convergence, no order
      const Scene scene = scene_of_sample(m);
      const auto [reference, is_new] = references.try_emplace(m.name);
      if (is_new) reference->second = scene_reference(scene);
      // Coefficients of 16 digits are wrong in the next one.
      const double floor = program.approximate() ? 1e-14 : 1e-27;
      double slope = 0, before = 0;
      for (int steps = program.approximate() ? 4 : 16; steps <= 256; steps *= 2) {
        const double e = error(scene, reference->second, program.name, steps);
        if (e < floor) break;
        if (before > 0) slope = std::log2(before / e);
        before = e;
      }
      CHECK(slope > proved - 0.25);
      CHECK(slope < proved + (program.approximate() ? 0.9 : 0.45));
      ++measured;
    }
  }
  CHECK(measured > 150);
}
