// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/motion/force.hpp"
#include "analysis/trade/trade.hpp"

using namespace shortfall;

namespace {

const TradeSeries& series(const std::vector<PeerSeries>& all, const std::string& label) {
  for (const PeerSeries& p : all)
    if (p.series.label == label) return p.series;
  FAIL("no series " << label);
  return all.front().series;
}

}  // namespace

TEST_CASE("other libraries reach the truth that the power series give, to what binary64 allows") {
  // Two ways that share nothing but the force's formula.
  for (const char* file : {"kepler", "charged-particle", "atlas", "grenade", "swing"}) {
    CAPTURE(std::string(file));
    Scene scene = read_scene(std::string(SHORTFALL_SOURCE_DIR "/scenes/") + file + ".toml");
    const SceneReference reference = scene_reference(scene);
    const std::vector<PeerSeries> all = peer_series(scene, reference, {scene.step});
    for (const char* label : {"GSL rk8pd, adaptive", "odeint bulirsch_stoer, adaptive"}) {
      CAPTURE(std::string(label));
      std::vector<double> least(scene.observables.size(), 1e300);
      for (const SceneOutcome& o : series(all, label).points)
        for (std::size_t i = 0; i < o.errors.size(); ++i)
          least[i] = std::min(least[i], std::fabs(o.errors[i]));
      for (std::size_t i = 0; i < least.size(); ++i) {
        double size = 1;
        for (const DoubleDouble& v : reference.readings[i].value) size = std::max(size, std::fabs(v.high()));
        CHECK(least[i] < 1e-8 * size);
      }
    }
  }
}

TEST_CASE(
    "a Runge-Kutta step of order 4 is the same in odeint and here, to rounding; GSL's is two half steps") {
  const Scene scene = read_scene(SHORTFALL_SOURCE_DIR "/scenes/atlas.toml");
  const SceneReference reference = scene_reference(scene);
  const std::vector<PeerSeries> all = peer_series(scene, reference, {scene.step});
  const auto ours = [&](const Rational& h) {
    return SceneStepping(scene, {"rk4", {}, false, "f64", h}).observe(reference).errors[0];
  };
  CHECK(series(all, "odeint runge_kutta4").points[0].errors[0] ==
        doctest::Approx(ours(scene.step)).epsilon(1e-7));
  CHECK(series(all, "GSL rk4").points[0].errors[0] ==
        doctest::Approx(ours(scene.step / Rational(2))).epsilon(1e-5));
}

TEST_CASE("observed orders: found where they are, refused where nothing is steady") {
  const std::vector<double> h{0.8, 0.4, 0.2, 0.1, 0.05, 0.025};
  std::vector<double> e;
  for (double s : h) e.push_back(3 * s * s * s);
  const auto found = observed_order(h, e, 0);
  REQUIRE(found);
  CHECK(found->order == doctest::Approx(3));
  CHECK(found->longest == 0.8);
  CHECK(found->shortest == 0.025);
  // Below the floor of a format a slope means nothing.
  e[4] = 1e-4;
  e[5] = 2e-4;
  const auto cut = observed_order(h, e, 1e-5);
  REQUIRE(cut);
  CHECK(cut->shortest == 0.1);
  CHECK(!observed_order(h, {1, 0.5, 0.1, 0.09, 0.01, 0.009}, 0));
  CHECK(!observed_order(h, {0, 0, 0, 0, 0, 0}, 0));
  CHECK(!observed_order({0.1}, {1}, 0));
}
