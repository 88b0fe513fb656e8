// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/trade/smooth_tape.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/double_double.hpp"
#include "analysis/trade/scene_model.hpp"
#include "analysis/trade/tape_run.hpp"

using namespace shortfall;

namespace {

/// A scene with every force that has a potential, one at a time.
std::string scene_with(const std::string& force, int dimension, bool angles = false) {
  const auto vector = [&](const char* a, const char* b, const char* c) {
    std::string text = std::string("[") + a;
    if (dimension > 1) text += std::string(", ") + b;
    if (dimension > 2) text += std::string(", ") + c;
    return text + "]";
  };
  return "until = 1\ndt = 0.1\ndimension = " + std::to_string(dimension) + "\n" +
         (angles ? "coordinates = \"angles\"\n" : "") +
         "[[body]]\nname = \"a\"\nmass = 2\nposition = " + vector("1", "0.5", "-0.3") +
         "\nvelocity = " + vector("0.1", "0.7", "0.2") +
         "\n[[body]]\nname = \"b\"\nmass = 3\nposition = " + vector("-1.3", "0.2", "0.9") +
         "\nvelocity = " + vector("0.2", "-0.4", "0.3") + "\n[[force]]\n" + force +
         "\n[[observable]]\nkind = \"position\"\ntolerance = 1\n";
}

struct Sample {
  const char* force;
  int dimension;
  bool angles = false;
};

const Sample kConservative[] = {
    {"kind = \"constant\"\nacceleration = [1, -2]", 2},
    {"kind = \"spring\"\nstiffness = 3\nanchor = [0.3, 1, 2]", 3},
    {"kind = \"spring\"\nstiffness = 3\nanchor = [0.3, 1]\nlength = 0.5", 2},
    {"kind = \"link\"\nbetween = [\"a\", \"b\"]\nstiffness = 3\nlength = 0.5", 3},
    {"kind = \"link\"\nbetween = [\"a\", \"b\"]\nstiffness = 3\nlength = 0.5", 1},
    {"kind = \"pendulum\"\ngravity = 9.81\nlength = 2", 1, true},
    {"kind = \"kepler\"\nmu = 2\ncentre = [0.1, 0.2, 0.3]", 3},
    {"kind = \"n-body\"\nG = 1.5", 3},
    {"kind = \"height-gravity\"\ngravity = 9.81\nradius = 100", 2},
    {"kind = \"lorentz\"\nelectric = [1, 2, 3]\nmagnetic = [0.3, -0.2, 1]", 3},
    {"kind = \"coriolis\"\nrotation = [0.1, 0.2, -0.3]", 3},
    {"kind = \"coriolis\"\nrotation = 0.4", 2},
    {"kind = \"potential\"\npotential = \"x^4/4 + exp(-y^2)*cos(x) + sqrt(2 + y)\"", 2},
};

}  // namespace

TEST_CASE(
    "forces that have a potential change the energy not at all: the gradient of E along the motion is zero") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> near(-0.8, 0.8);
  for (const Sample& sample : kConservative) {
    CAPTURE(sample.force);
    CAPTURE(sample.dimension);
    const Scene scene = scene_of(scene_with(sample.force, sample.dimension, sample.angles), "test.toml");
    const auto energy = energy_tape(scene);
    REQUIRE(energy);
    const SmoothTape acceleration = acceleration_tape(scene);
    const int m = scene.coordinates();
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<DoubleDouble> x, v;
      for (const SceneBody& b : scene.bodies)
        for (const Rational& c : b.position) x.push_back(DoubleDouble(c.to_double() + 0.3 * near(random)));
      for (int i = 0; i < m; ++i) v.emplace_back(near(random));
      const DoubleDouble t(near(random));
      std::vector<DoubleDouble> a(static_cast<std::size_t>(m));
      TapeValues<DoubleDouble> force(acceleration);
      force(x.data(), v.data(), t, m, a.data());
      // The derivative of E in the direction (v, a), by one nilpotent part.
      using Number = Nilpotent<DoubleDouble>;
      std::vector<Number> nx, nv, work(energy->nodes.size());
      for (int i = 0; i < m; ++i) {
        nx.emplace_back(1, x[static_cast<std::size_t>(i)]);
        nx.back().part(1) = v[static_cast<std::size_t>(i)];
        nv.emplace_back(1, v[static_cast<std::size_t>(i)]);
        nv.back().part(1) = a[static_cast<std::size_t>(i)];
      }
      Number out;
      run_tape(
          *energy, nx.data(), nv.data(), Number(1, t), m,
          [](const Rational& r) { return Number(1, double_double(r)); }, work, &out);
      CHECK(std::fabs(out.part(1).high()) < 1e-27);
      CHECK(std::isfinite(out.part(0).high()));
    }
  }
}

TEST_CASE("compiled terms and the tape give the same force") {
  for (const Sample& sample : kConservative) {
    CAPTURE(sample.force);
    const Scene scene = scene_of(scene_with(sample.force, sample.dimension, sample.angles), "test.toml");
    const int m = scene.coordinates();
    std::vector<double> x, v, by_terms(static_cast<std::size_t>(m)), by_tape(static_cast<std::size_t>(m));
    for (const SceneBody& b : scene.bodies) {
      for (const Rational& c : b.position) x.push_back(c.to_double());
      for (const Rational& c : b.velocity) v.push_back(c.to_double());
    }
    SceneAcceleration<double> terms(scene);
    terms(x.data(), v.data(), 0.5, by_terms.data());
    TapeValues<double> tape(acceleration_tape(scene));
    tape(x.data(), v.data(), 0.5, m, by_tape.data());
    for (int i = 0; i < m; ++i)
      CHECK(by_terms[static_cast<std::size_t>(i)] ==
            doctest::Approx(by_tape[static_cast<std::size_t>(i)]).epsilon(1e-14));
  }
}

TEST_CASE("derivatives by nilpotent numbers are those of calculus") {
  using Number = Nilpotent<DoubleDouble>;
  Number x(3, DoubleDouble(0.7));
  for (std::size_t d = 0; d < 3; ++d) x.part(std::size_t{1} << d) = DoubleDouble(1);
  const auto third = [](const Number& n) { return n.part(7).high(); };
  CHECK(third(x * x * x) == doctest::Approx(6));
  CHECK(third(exp(x)) == doctest::Approx(std::exp(0.7)).epsilon(1e-15));
  CHECK(third(sin(x)) == doctest::Approx(-std::cos(0.7)).epsilon(1e-15));
  CHECK(third(cos(x)) == doctest::Approx(std::sin(0.7)).epsilon(1e-15));
  CHECK(third(log(x)) == doctest::Approx(2 / (0.7 * 0.7 * 0.7)).epsilon(1e-15));
  CHECK(third(sqrt(x)) == doctest::Approx(0.375 * std::pow(0.7, -2.5)).epsilon(1e-15));
  CHECK(third(Number(3, DoubleDouble(1)) / x) == doctest::Approx(-6 / std::pow(0.7, 4)).epsilon(1e-15));
}

TEST_CASE("constants are folded, and nothing is recorded twice") {
  TapeRecorder r(3);
  const int sum = r.binary(SmoothTape::Op::add, r.constant(Rational(1, 3)), r.constant(Rational(2, 3)));
  REQUIRE(r.constant_value(sum));
  CHECK(r.constant_value(sum)->is_one());
  CHECK(r.binary(SmoothTape::Op::multiply, sum, r.input(0)) == r.input(0));
  CHECK(r.unary(SmoothTape::Op::sin, r.input(1)) == r.unary(SmoothTape::Op::sin, r.input(1)));
  CHECK(r.unary(SmoothTape::Op::cos, r.input(1)) == r.unary(SmoothTape::Op::sin, r.input(1)) + 1);
  CHECK_THROWS_AS(r.binary(SmoothTape::Op::divide, r.input(0), r.constant(0)), Undefined);
}
