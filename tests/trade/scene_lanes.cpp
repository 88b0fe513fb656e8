// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/scene_lanes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>

#include "analysis/algebra/error.hpp"
#include "analysis/native/native_run.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/trade/rounded_number.hpp"
#include "analysis/trade/trade.hpp"

namespace shortfall {
namespace {

Scene line_scene(const std::string& forces, const std::string& more = "") {
  return scene_of("until = 1\ndt = 0.01\n" + more + "[[body]]\nposition = 0.7\nvelocity = -0.3\n" + forces +
                      "\n[[observable]]\nkind = \"position\"\ntolerance = 1\n",
                  "lanes.toml");
}

/// Where one motion is after so many steps, stepped alone.
template <class S>
std::pair<double, double> alone(const Scene& scene, const StepChoice& choice, S x0, std::int64_t steps) {
  SceneAcceleration<S> acceleration(scene);
  const auto force = [&](std::span<const S> x, std::span<const S> v, S t, std::span<S> a) {
    acceleration(x.data(), v.data(), t, a.data());
  };
  const auto run =
      native_run<S>(find_integrator(choice.integrator), choice.parameters,
                    rounded_number<S>(choice.frame / Rational(choice.substeps)), 1, ForceReference<S>(force));
  S v = rounded_number<S>(scene.bodies[0].velocity[0]);
  run->begin({&x0, 1}, {&v, 1}, 0);
  run->run(steps * choice.substeps);
  run->read_out({&x0, 1}, {&v, 1});
  return {x0, v};
}

template <class S>
void check_bits(const Scene& scene, const StepChoice& choice) {
  constexpr int kCount = 37;  // two blocks and a part
  SceneLanes lanes(scene, choice, kCount);
  lanes.run(53);
  S x0 = rounded_number<S>(scene.bodies[0].position[0]);
  for (int i = 0; i < kCount; ++i) {
    const auto [x, v] = alone<S>(scene, choice, x0, 53);
    const auto [lane_x, lane_v] = lanes.state(i);
    CHECK(lane_x == x);
    CHECK(lane_v == v);
    REQUIRE(std::isfinite(x));
    x0 = std::nextafter(x0, S(INFINITY));
  }
}

TEST_CASE("side by side every motion has the bits that it has alone") {
  const Scene scenes[] = {
      line_scene("[[force]]\nkind = \"expression\"\nacceleration = \"-2*sin(x)*cos(vx) - vx*sqrt(x*x + 1) + "
                 "exp(-t)/(2 + x) - max(x, vx) + pow(x*x + 1, 1/3) - log(x*x + 2)\"\n"),
      line_scene("[[force]]\nkind = \"spring\"\nstiffness = 2\ndamping = 0.1\n[[force]]\nkind = "
                 "\"quadratic-drag\"\ncoefficient = 0.3\n[[force]]\nkind = \"expression\"\nacceleration = "
                 "\"x - x^3\"\n"),
      line_scene("[[force]]\nkind = \"potential\"\npotential = \"x^4/4 - x^2\"\n"),
  };
  for (const Scene& scene : scenes)
    for (const char* integrator : {"explicit-euler", "symplectic-euler", "velocity-verlet", "rk4"}) {
      CAPTURE(integrator);
      StepChoice choice{integrator, {}, false, "f64", Rational(1, 100)};
      if (why_no_lanes(scene, choice)) {
        MESSAGE("no lanes here: " << *why_no_lanes(scene, choice));
        return;
      }
      check_bits<double>(scene, choice);
      choice.substeps = 3;
      check_bits<double>(scene, choice);
      choice.format = "f32";
      check_bits<float>(scene, choice);
    }
}

TEST_CASE("what cannot be stepped side by side is refused with its reason") {
  const Scene scene = line_scene("[[force]]\nkind = \"spring\"\nstiffness = 2\n");
  StepChoice choice{"rk4", {}, true, "f64", Rational(1, 100)};
  CHECK(why_no_lanes(scene, choice)->find("launch") != std::string::npos);
  CHECK_THROWS_AS(SceneLanes(scene, choice, 8), Unable);
  choice.launched = false;
  choice.format = "dd";
  CHECK(why_no_lanes(scene, choice)->find("f32 and f64") != std::string::npos);
  choice = {"implicit-euler", {}, false, "f64", Rational(1, 100)};
  CHECK(why_no_lanes(scene, choice)->find("one motion after the other") != std::string::npos);
  const Scene held = line_scene("[[force]]\nkind = \"spring\"\nstiffness = 2\nheld = true\n");
  CHECK(why_no_lanes(held, {"rk4", {}, false, "f64", Rational(1, 100)})->find("held") != std::string::npos);
  const Scene plane = scene_of(
      "until = 1\ndt = 0.01\ndimension = 2\n[[body]]\nposition = [1, 0]\nvelocity = [0, 1]\n[[force]]\nkind "
      "= "
      "\"kepler\"\nmu = 1\n[[observable]]\nkind = \"position\"\ntolerance = 1\n",
      "plane.toml");
  CHECK(why_no_lanes(plane, {"rk4", {}, false, "f64", Rational(1, 100)})->find("one coordinate") !=
        std::string::npos);
}

TEST_CASE("a trade has lanes as series of their own, with the same errors; none is called the cheapest") {
  const Scene scene = line_scene("[[force]]\nkind = \"spring\"\nstiffness = 2\n");
  TradeQuestion question;
  question.integrators = {"velocity-verlet", "implicit-euler"};
  question.formats = {"f64"};
  question.launches = question.peers = false;
  question.repeats = 2;
  question.at_once = 64;
  const Trade result = trade(scene, question);
  const TradeSeries* one = nullptr;
  const TradeSeries* many = nullptr;
  for (const TradeSeries& s : result.series)
    if (s.integrator == "velocity-verlet") (s.at_once ? many : one) = &s;
  REQUIRE(one);
  if (!many) {
    MESSAGE("no lanes here");
    return;
  }
  CHECK(many->label == "velocity-verlet, f64, 64 at once");
  REQUIRE(many->points.size() == one->points.size());
  for (std::size_t i = 0; i < one->points.size(); ++i) {
    CHECK(many->points[i].errors == one->points[i].errors);
    CHECK(many->points[i].nanoseconds > 0);
  }
  for (const TradePlace& p : pareto_front(result, 0)) CHECK(result.series[p.series].at_once == 0);
  const auto best = cheapest(result);
  if (best) CHECK(result.series[best->series].at_once == 0);
  bool refused = false;
  for (const auto& [label, why] : result.refused) refused |= label == "implicit-euler, f64, 64 at once";
  CHECK(refused);
}

}  // namespace
}  // namespace shortfall
