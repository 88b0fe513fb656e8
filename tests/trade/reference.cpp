// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/reference.hpp"

#include <doctest/doctest.h>
#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "analysis/trade/taylor_numbers.hpp"

using namespace shortfall;

namespace {

/// Kepler's problem from the perihelion, mu = 1, semi-axis 1.
std::string kepler(const std::string& eccentricity, const std::string& until) {
  const Rational e = Rational::parse(eccentricity);
  const double speed = std::sqrt(((1 + e.to_double()) / (1 - e.to_double())));
  return "dimension = 2\nuntil = " + until + "\ndt = 0.1\n[[body]]\nposition = [" +
         (Rational(1) - e).significant(20) + ", 0]\nvelocity = [0, " +
         Rational::from_double(speed).significant(17) +
         "]\n[[force]]\nkind = \"kepler\"\nmu = 1\n[[observable]]\nkind = \"position\"\ntolerance = 1e-6\n"
         "[[observable]]\nkind = \"energy-drift\"\ntolerance = 1e-6\n";
}

}  // namespace

TEST_CASE("Kepler's equation: the place on an ellipse of eccentricity 0.6 is that of E - e sin E = t") {
  // sqrt((1 + e)/(1 - e)) = 2 exactly, so that the semi-axis is 1.
  const Scene scene = scene_of(kepler("0.6", "20"), "kepler.toml");
  for (int digits : {30, 60}) {
    const SceneReference reference = scene_reference(scene, digits);
    const Precision precision(80);
    Real eccentric = Real(20), e = real(Rational(3, 5), 80);
    for (int round = 0; round < 60; ++round)
      eccentric -= (eccentric - e * sin(eccentric) - Real(20)) / (Real(1) - e * cos(eccentric));
    const Real x = cos(eccentric) - e, y = real(Rational(4, 5), 80) * sin(eccentric);
    const auto& place = reference.readings[0].value;
    CHECK(std::fabs(rough(place[0] - DoubleDouble(x.convert_to<double>(),
                                                  Real(x - x.convert_to<double>()).convert_to<double>()))) <
          1e-27);
    CHECK(std::fabs(rough(place[1] - DoubleDouble(y.convert_to<double>(),
                                                  Real(y - y.convert_to<double>()).convert_to<double>()))) <
          1e-27);
    CHECK(reference.uncertain[0] < 1e-26);
  }
}

TEST_CASE("the period of a pendulum is 4 K(sin(angle/2)) sqrt(l/g)") {
  const Scene scene = scene_of(
      "coordinates = \"angles\"\nuntil = 40\ndt = 0.1\n[[body]]\nposition = 2.5\n[[force]]\nkind = "
      "\"pendulum\"\n"
      "gravity = 1\nlength = 1\n[[event]]\nname = \"low\"\ndirection = \"up\"\n[[observable]]\nkind = "
      "\"period\"\n"
      "event = \"low\"\ncount = 3\ntolerance = 1e-6\n[[observable]]\nkind = \"event-time\"\nevent = \"low\"\n"
      "tolerance = 1e-6\n",
      "pendulum.toml");
  const SceneReference reference = scene_reference(scene);
  const double period = 4 * gsl_sf_ellint_Kcomp(std::sin(1.25), GSL_PREC_DOUBLE);
  CHECK(reference.readings[0].value[0].high() == doctest::Approx(period).epsilon(1e-14));
  CHECK(reference.readings[1].value[0].high() == doctest::Approx(0.75 * period).epsilon(1e-14));
}

TEST_CASE("a fall with quadratic drag, up and down: the corner at the top is met exactly") {
  // Upwards v = tan(arctan(v0) - t), the top at log(1 + v0^2)/2 after arctan(v0); downwards log cosh.
  const Scene scene = scene_of(
      "until = 10\ndt = 0.1\n[[body]]\nposition = 0\nvelocity = 2\n[[force]]\nkind = "
      "\"constant\"\nacceleration = -1\n"
      "[[force]]\nkind = \"quadratic-drag\"\ncoefficient = 1\n[[event]]\nname = \"ground\"\ndirection = "
      "\"down\"\n"
      "ends = true\n[[observable]]\nkind = \"peak\"\ntolerance = 1e-6\n[[observable]]\nkind = \"apex-time\"\n"
      "tolerance = 1e-6\n[[observable]]\nkind = \"event-time\"\nevent = \"ground\"\ntolerance = 1e-6\n",
      "throw.toml");
  const SceneReference reference = scene_reference(scene);
  const double top = std::log(5.0) / 2;
  CHECK(reference.readings[0].value[0].high() == doctest::Approx(top).epsilon(1e-15));
  CHECK(reference.readings[1].value[0].high() == doctest::Approx(std::atan(2.0)).epsilon(1e-15));
  CHECK(reference.readings[2].value[0].high() ==
        doctest::Approx(std::atan(2.0) + std::acosh(std::exp(top))).epsilon(1e-14));
  CHECK(reference.end.high() == reference.readings[2].value[0].high());
  for (double off : reference.uncertain) CHECK(off < 1e-24);
}

TEST_CASE("functions of expressions: series of exp, log, sin, cos, powers against solutions in closed form") {
  // x = f(t) solves x'' = f''(t), whatever f.
  struct Closed {
    const char* force;
    double (*x)(double);
    double v0;
    double x0;
  };
  const Closed all[] = {
      {"exp(t)", [](double t) { return std::exp(t); }, 1, 1},
      {"-1/(1 + t)^2", [](double t) { return std::log(1 + t); }, 1, 0},
      {"-sin(t)", [](double t) { return std::sin(t); }, 1, 0},
      {"-cos(t)", [](double t) { return std::cos(t); }, 0, 1},
      {"-(1 + t)^(-3/2)/4", [](double t) { return std::sqrt(1 + t); }, 0.5, 1},
      {"cosh(t)", [](double t) { return std::cosh(t); }, 0, 1},
      {"x", [](double t) { return std::exp(-t); }, -1, 1},
  };
  for (const Closed& c : all) {
    CAPTURE(c.force);
    const Scene scene =
        scene_of("until = 2\ndt = 0.1\n[[body]]\nposition = " + Rational::from_double(c.x0).str() +
                     ".0\nvelocity = " + Rational::from_double(c.v0).significant(5) +
                     "\n[[force]]\nkind = \"expression\"\nacceleration = \"" + c.force +
                     "\"\n[[observable]]\nkind = \"position\"\ntolerance = 1e-9\n",
                 "closed.toml");
    CHECK(scene_reference(scene).readings[0].value[0].high() == doctest::Approx(c.x(2)).epsilon(1e-15));
  }
  // x = tan t solves x'' = 2 x x'.
  const Scene tangent = scene_of(
      "until = 1\ndt = 0.1\n[[body]]\nposition = 0\nvelocity = 1\n[[force]]\nkind = \"expression\"\n"
      "acceleration = \"2*x*vx\"\n[[observable]]\nkind = \"position\"\ntolerance = 1e-9\n",
      "tangent.toml");
  CHECK(scene_reference(tangent).readings[0].value[0].high() ==
        doctest::Approx(std::tan(1.0)).epsilon(1e-15));
}

TEST_CASE("what has no true value is refused with the reason") {
  const auto refusal = [](const std::string& text) {
    try {
      scene_reference(scene_of(text, "t.toml"));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string fall =
      "until = 1\ndt = 0.1\n[[body]]\nposition = 10\n[[force]]\nkind = \"linear-drag\"\nrate = 1\n[[event]]\n"
      "name = \"floor\"\n";
  CHECK(refusal(fall + "[[observable]]\nkind = \"event-time\"\nevent = \"floor\"\ntolerance = 1\n")
            .find("is passed never") != std::string::npos);
  CHECK(refusal(fall + "[[observable]]\nkind = \"energy-drift\"\ntolerance = 1\n").find("has no energy") !=
        std::string::npos);
  // Straight into the centre.
  CHECK(!refusal("until = 10\ndt = 0.1\ndimension = 2\n[[body]]\nposition = [1, 0]\n[[force]]\nkind = "
                 "\"kepler\"\nmu = 1\n"
                 "[[observable]]\nkind = \"position\"\ntolerance = 1\n")
             .empty());
}
