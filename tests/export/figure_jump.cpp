// SPDX-License-Identifier: GPL-3.0-or-later
#include "notebooks-export/figure_jump.hpp"

#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"

using namespace shortfall;

TEST_CASE(
    "the picture of a jump draws symplectic Euler's shortfall g dt t / 2 in centimetres, at each frame "
    "rate") {
  const Program program = find_integrator("symplectic-euler");
  std::vector<Flight> flights;
  for (const int rate : {30, 120}) flights.emplace_back(program, Rational(1, rate));
  const Figure figure = jump_figure(flights, Rational(17, 10), Rational(981, 100));
  REQUIRE(figure.panels.size() == 2);
  REQUIRE(figure.panels[0].curves.size() == 3);  // the parabola and two jumps
  const auto& curves = figure.panels[1].curves;
  REQUIRE(curves.size() == 2);
  for (std::size_t f = 0; f < 2; ++f) {
    const double dt = f == 0 ? 1.0 / 30 : 1.0 / 120;
    REQUIRE(curves[f].paths[0].size() == (f == 0 ? 36 : 142));  // landing after 1.177 s
    for (const Figure::Point& p : curves[f].paths[0])
      CHECK(p.y == doctest::Approx(100 * 9.81 * dt * p.x / 2));
  }
  CHECK(figure.panels[1].y.high > 19);
  CHECK(figure.panels[1].y.unit == "cm");
  REQUIRE(figure.panels[1].labels.size() == 2);
  CHECK(figure.panels[1].labels[0].text == "120 Hz");
}
