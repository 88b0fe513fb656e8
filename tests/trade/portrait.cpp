// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/portrait.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/typing.hpp"

namespace shortfall {
namespace {

Expr of_x(const std::string& text) {
  Names names;
  names.force = false;
  names.functions = Functions::all;
  names.declare("x", Type{});
  return parse_formula(text, "V", names, Type{});
}

PortraitQuestion question(const std::string& potential, const Rational& h, int order, int steps) {
  PortraitQuestion q;
  q.potential = of_x(potential);
  q.h = h;
  q.order = order;
  q.steps = steps;
  q.starts = {{Rational(1), Rational(1, 4)}};
  return q;
}

/// From the first frame on: a start may put the body on another orbit than it was given.
double change_of_modified(const Program& program, const PortraitQuestion& q) {
  std::vector<double> values = portrait(program, q).orbits[0].modified;
  values.erase(values.begin());
  return PortraitOrbit::largest_change(values);
}

TEST_CASE("derivatives of a potential are those of school") {
  struct Sample {
    const char* text;
    std::vector<double> at;  // V, V', ... at x = 0.7
  };
  const double x = 0.7, s = std::sin(x), c = std::cos(x), e = std::exp(-2 * x);
  for (const Sample& sample :
       {Sample{"x^4/4 - x", {x * x * x * x / 4 - x, x * x * x - 1, 3 * x * x, 6 * x, 6, 0}},
        Sample{"cos(x)", {c, -s, -c, s, c, -s}},
        Sample{"exp(-2*x)", {e, -2 * e, 4 * e, -8 * e, 16 * e, -32 * e}},
        Sample{"1/x",
               {1 / x, -1 / (x * x), 2 / (x * x * x), -6 / std::pow(x, 4), 24 / std::pow(x, 5),
                -120 / std::pow(x, 6)}}}) {
    CAPTURE(sample.text);
    TapeValues<double> tape(potential_tape(of_x(sample.text), 5));
    std::vector<double> d(6);
    const double nothing = 0;
    tape(&x, &nothing, nothing, 1, d.data());
    for (std::size_t k = 0; k < d.size(); ++k) CHECK(d[k] == doctest::Approx(sample.at[k]).epsilon(1e-12));
  }
}

TEST_CASE("on a spring the level lines of symplectic Euler's modified energy are x^2 - h x v + v^2") {
  const Program program = find_integrator("symplectic-euler");
  const PortraitQuestion q = question("x^2/2", Rational(1, 2), 8, 500);
  const Portrait p = portrait(program, q);
  CHECK(PortraitOrbit::largest_change(p.orbits[0].modified) < 1e-13);
  CHECK(PortraitOrbit::largest_change(p.orbits[0].energy) > 0.1);
  EnergySurfaces surfaces = surfaces_of(p, program);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(-2, 2);
  double ratio = 0;
  for (int i = 0; i < 50; ++i) {
    const double x = draw(random), v = draw(random);
    const double form = x * x - x * v / 2 + v * v;
    if (form < 0.1) continue;
    const double found = surfaces.at(x, v).modified / form;
    if (ratio == 0) ratio = found;
    CHECK(found == doctest::Approx(ratio).epsilon(1e-13));
    CHECK(surfaces.at(x, v).energy == doctest::Approx((x * x + v * v) / 2));
    CHECK(surfaces.force(x) == -x);
  }
}

TEST_CASE("cut before h^N, a modified energy stays the same up to h^N: for every step that has one") {
  // Over a fixed time; the constants of a pendulum and of a quartic well are moderate.
  int with = 0, without = 0;
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    for (const char* potential : {"1 - cos(x)", "x^2/2 + x^4/8 - x^3/9"}) {
      PortraitQuestion q = question(potential, Rational(1, 20), 6, 200);
      try {
        if (!portrait(program, q).hamiltonian.exists()) {
          ++without;
          break;
        }
      } catch (const Unable&) {
        break;  // no series: tested elsewhere
      }
      const double coarse = change_of_modified(program, q);
      q.h = Rational(1, 40);
      q.steps = 400;
      const double fine = change_of_modified(program, q);
      ++with;
      CAPTURE(potential);
      CAPTURE(coarse);
      CAPTURE(fine);
      CHECK(coarse < 1e-4);
      // A factor of 2^6; rounding is the floor of the best.
      CHECK(fine < std::max(coarse / 45, 1e-13));
    }
  }
  CHECK(with >= 20);
  CHECK(without >= 5);
}

TEST_CASE("a motion that runs away or leaves the domain of V ends there, and says which") {
  const Program program = find_integrator("symplectic-euler");
  const Portrait away = portrait(program, question("-x^4", Rational(1, 2), 4, 100));
  REQUIRE(away.orbits[0].lost);
  CHECK_FALSE(away.orbits[0].no_number);
  CHECK(away.orbits[0].x.size() == static_cast<std::size_t>(*away.orbits[0].lost));
  const Portrait left = portrait(program, question("sqrt(x)", Rational(1, 2), 4, 100));
  REQUIRE(left.orbits[0].lost);
  CHECK(left.orbits[0].no_number);
  PortraitQuestion nowhere = question("1/x", Rational(1, 2), 4, 100);
  nowhere.starts = {{Rational(0), Rational(1)}};
  CHECK_THROWS_AS(portrait(program, nowhere), Undefined);
  nowhere.potential = of_x("1e20*x");
  nowhere.starts = {{Rational(1), Rational(1)}};
  CHECK(portrait(program, nowhere).orbits[0].lost == 1);
  nowhere.starts.clear();
  CHECK_THROWS_AS(portrait(program, nowhere), BadInput);
}

TEST_CASE("substeps are steps of their own, and have the modified energy of the smaller step") {
  const Program program = find_integrator("velocity-verlet");
  PortraitQuestion frames = question("1 - cos(x)", Rational(1, 2), 6, 20);
  frames.substeps = 4;
  PortraitQuestion steps = question("1 - cos(x)", Rational(1, 8), 6, 80);
  const Portrait a = portrait(program, frames), b = portrait(program, steps);
  for (std::size_t n = 0; n < a.orbits[0].x.size(); ++n) {
    CHECK(a.orbits[0].x[n] == doctest::Approx(b.orbits[0].x[4 * n]).epsilon(1e-13));
    CHECK(a.orbits[0].modified[n] == doctest::Approx(b.orbits[0].modified[4 * n]).epsilon(1e-13));
  }
}

}  // namespace
}  // namespace shortfall
