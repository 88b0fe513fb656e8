// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that go to another engine, and what several frame rates say. Truth: the loops, written out here.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/by_dt.hpp"
#include "analysis/identify/port.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall {
namespace {

TEST_CASE("a jump of PhysX with damping goes to Rapier, and its loop makes the same frames") {
  PortQuestion q;
  const Program physx = find_integrator("physx"), rapier = find_integrator("rapier");
  q.from = candidate(physx, std::nullopt);
  q.to = candidate(rapier, std::nullopt);
  q.from_dt = q.to_dt = Rational(1, 60);
  q.c = 0.5;
  q.launch = std::sqrt(2 * 9.81 * 1.7);
  const Port p = port(q);
  CHECK(p.exact);
  const double dt = 1.0 / 60;
  double x = 0, v = q.launch, y = p.fit.x0[1].value, w = p.fit.v0[1].value;
  for (int n = 0; n < 60; ++n) {
    v = (v - 9.81 * dt) * (1 - 0.5 * dt);
    x += v * dt;
    for (int k = 0; k < 4; ++k) {
      w += (-9.81 + p.held) * dt / 4;
      y += w * dt / 4;
    }
    w /= 1 + p.fit.c.value * dt;
    CHECK(y == doctest::Approx(x).epsilon(1e-9));
  }
}

TEST_CASE("another tick rate: the frames in common are the same") {
  const Program jolt = find_integrator("jolt");
  PortQuestion q;
  q.from = q.to = candidate(jolt, 1);
  q.from_dt = Rational(1, 60);
  q.to_dt = Rational(1, 120);
  q.launch = 5;
  const Port p = port(q);
  CHECK(p.exact);
  double x = 0, v = 5, y = p.fit.x0[1].value, w = p.fit.v0[1].value;
  for (int n = 0; n < 30; ++n) {
    v -= 9.81 / 60;
    x += v / 60;
    for (int k = 0; k < 2; ++k) {
      w += (-9.81 + p.held) / 120;
      y += w / 120;
    }
    CHECK(y == doctest::Approx(x).epsilon(1e-9));
  }
}

TEST_CASE("peaks of 165, 150 and 142.5 px are first order towards 135, of a step that drifts first") {
  const ByDt r =
      by_dt({{Rational(1, 30), 165}, {Rational(1, 60), 150}, {Rational(1, 120), Rational(285, 2)}});
  CHECK(r.order == 1);
  CHECK(r.whole_order);
  CHECK(r.limit == doctest::Approx(135));
  CHECK(r.slope == doctest::Approx(900));
  CHECK(std::ranges::find(r.maps, "explicit-euler") != r.maps.end());
  CHECK(std::ranges::find(r.maps, "symplectic-euler") == r.maps.end());
  CHECK_THROWS_AS(by_dt({{Rational(1, 30), 165}, {Rational(1, 60), 150}}), BadInput);
  CHECK_THROWS_AS(by_dt({{Rational(1, 30), 1}, {Rational(1, 60), 2}, {Rational(1, 120), 1}}), Undefined);
}

TEST_CASE("second order is seen as such") {
  const ByDt r = by_dt({{Rational(1, 10), Rational(104, 100)},
                        {Rational(1, 20), Rational(101, 100)},
                        {Rational(1, 40), Rational(10025, 10000)}});
  CHECK(r.order == 2);
  CHECK(r.limit == doctest::Approx(1));
}

}  // namespace
}  // namespace shortfall
