// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/native/native_run.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/floating/float_run.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

/// The number that a native run reports, exactly.
FloatNumber exactly(double value) {
  if (std::isnan(value)) return {FloatNumber::Kind::not_a_number, {}};
  if (std::isinf(value)) return {FloatNumber::Kind::infinite, value < 0 ? -1 : 1};
  return {FloatNumber::Kind::finite, Rational::from_double(value)};
}

bool same(const FloatNumber& a, const FloatNumber& b) { return a.kind == b.kind && a.value == b.value; }

/// A damped spring, driven: f0 + t f1 - k x - c v, in the order in which FloatRun computes it.
template <class S>
void check_against_float_run(const char* format, S (*round)(const Rational&)) {
  std::mt19937_64 generator(11);
  const auto draw = [&](int low, int high) {
    return Rational(std::uniform_int_distribution<int>(997 * low, 997 * high)(generator)) / Rational(997);
  };
  for (const Program& program : catalogue()) {
    CAPTURE(program.name);
    FloatQuestion q;
    q.program = program;
    q.force = force_named("damped-spring:k=4,c=1/3");
    q.force.k = draw(1, 9);
    q.force.c = draw(0, 1);
    q.h = draw(1, 2) / Rational(30);
    q.x0 = draw(-2, 2);
    q.v0 = draw(-2, 2);
    const S k = round(*q.force.k), c = round(*q.force.c);
    const auto force = [&](std::span<const S> x, std::span<const S> v, S, std::span<S> a) {
      a[0] = -(k * x[0]) - c * v[0];
    };
    const auto interpreted = float_run(float_format(format), q);
    const auto native = native_run<S>(program, {}, round(q.h), 1, force);
    const S x0 = round(q.x0), v0 = round(q.v0);
    native->begin({&x0, 1}, {&v0, 1}, 0);
    for (int done = 0; done < 300; done += 50) {
      for (int n = 0; n < 50; ++n) interpreted->step();
      native->run(50);
      S x{}, v{};
      native->read_out({&x, 1}, {&v, 1});
      const auto [ix, iv] = interpreted->state();
      CHECK(same(ix, exactly(static_cast<double>(x))));
      CHECK(same(iv, exactly(static_cast<double>(v))));
    }
  }
}

/// One number of each coordinate.
constexpr std::array<double, 5> kStart{0.3, -1.1, 0.7, 2.2, -0.4};
constexpr std::array<double, 5> kStartVelocity{1.3, 0.2, -0.9, 0.1, 0.5};

void spring(std::span<const double> x, std::span<const double> v, double t, std::span<double> a) {
  for (std::size_t i = 0; i < x.size(); ++i) a[i] = -2.5 * x[i] - 0.1 * v[i] + 0.3 * t;
}

bool is_implicit(const std::vector<Statement>& block) {
  for (const Statement& s : block)
    if (s.kind == Statement::Kind::solve || is_implicit(s.body)) return true;
  return false;
}

}  // namespace

TEST_CASE("a native run of the catalogue has the bits of FloatRun in binary64 and binary32") {
  check_against_float_run<double>("f64", [](const Rational& r) { return r.to_double(); });
  check_against_float_run<float>("f32", [](const Rational& r) { return r.to_float(); });
}

TEST_CASE("coordinates that do not know of each other are stepped as if they were alone") {
  int compared = 0;
  for (const Program& program : catalogue()) {
    const bool implicit = is_implicit(program.step);
    CAPTURE(program.name);
    for (const std::size_t dimension : {2u, 3u, 5u}) {
      const auto together = native_run<double>(program, {}, 0.02, dimension, spring);
      together->begin(std::span(kStart).first(dimension), std::span(kStartVelocity).first(dimension), 0.25);
      together->run(200);
      std::array<double, 5> x{}, v{};
      together->read_out(std::span(x).first(dimension), std::span(v).first(dimension));
      for (std::size_t i = 0; i < dimension; ++i) {
        const auto alone = native_run<double>(program, {}, 0.02, 1, spring);
        alone->begin({&kStart[i], 1}, {&kStartVelocity[i], 1}, 0.25);
        alone->run(200);
        double ax = 0, av = 0;
        alone->read_out({&ax, 1}, {&av, 1});
        CHECK(alone->time() == together->time());
        // Newton's iteration of a whole vector ends when all of it has settled.
        if (implicit) {
          CHECK(std::abs(ax - x[i]) < 1e-11);
          CHECK(std::abs(av - v[i]) < 1e-11);
        } else {
          CHECK(ax == x[i]);
          CHECK(av == v[i]);
        }
        ++compared;
      }
    }
  }
  CHECK(compared > 600);
}

TEST_CASE("a limit measures the length of the whole velocity") {
  const auto none = [](auto, auto, double, std::span<double> a) { a[0] = a[1] = 0; };
  const auto run =
      native_run<double>(find_integrator("jolt"), {{"S", Rational(5)}, {"c", Rational(0)}}, 0.02, 2, none);
  const std::array<double, 2> x0{0, 0}, v0{30, 40};
  run->begin(x0, v0, 0);
  run->run(1);
  std::array<double, 2> x{}, v{};
  run->read_out(x, v);
  CHECK(v[0] == doctest::Approx(3));
  CHECK(v[1] == doctest::Approx(4));
}

TEST_CASE("evaluations of the force are counted") {
  const double x0 = 1, v0 = 0;
  const auto count = [&](const char* name, int steps) {
    const auto run = native_run<double>(find_integrator(name), {}, 0.02, 1, spring);
    run->begin({&x0, 1}, {&v0, 1}, 0);
    run->run(steps);
    return run->force_evaluations();
  };
  CHECK(count("symplectic-euler", 100) == 100);
  CHECK(count("rk4", 100) == 400);
  CHECK(count("velocity-verlet", 100) == 101);
  CHECK(count("rapier", 100) == 100);  // held over its substeps
}

TEST_CASE("an impulse acts in the next step only") {
  const auto none = [](auto, auto, double, std::span<double> a) { a[0] = 0; };
  const auto run = native_run<double>(find_integrator("jolt"), {{"c", Rational(0)}}, 0.5, 1, none);
  const double x0 = 0, v0 = 0, impulse = 3;
  double x = 0, v = 0;
  run->begin({&x0, 1}, {&v0, 1}, 0);
  run->give_impulse({&impulse, 1});
  run->run(4);
  run->read_out({&x, 1}, {&v, 1});
  CHECK(v == 3);
  CHECK(x == 6);
  const auto verlet = native_run<double>(find_integrator("velocity-verlet"), {}, 0.5, 1, none);
  CHECK_THROWS_AS(verlet->give_impulse({&impulse, 1}), BadInput);
}

TEST_CASE("what cannot be run is refused with its reason") {
  const Program rk4 = find_integrator("rk4");
  CHECK_THROWS_AS(native_run<double>(rk4, {}, 0.02, kMostNativeComponents + 1, spring), Unable);
  CHECK_THROWS_AS(native_run<double>(rk4, {}, 0.02, 0, spring), Unable);
  CHECK_THROWS_AS(native_run<double>(rk4, {{"beta", Rational(1)}}, 0.02, 1, spring), BadInput);
  CHECK_THROWS_AS(native_run<double>(find_integrator("jolt"), {{"N", Rational(1, 2)}}, 0.02, 1, spring),
                  BadInput);
  const Program own = parse("integrator rk4\n  source nobody\n\nstep\n  x = x + h*v\n", "own.integrator");
  REQUIRE(why_not_native(own));
  CHECK(why_not_native(own)->find("no integrator of the catalogue") != std::string::npos);
  CHECK_THROWS_AS(native_run<double>(own, {}, 0.02, 1, spring), Unable);
  const auto run = native_run<double>(rk4, {}, 0.02, 3, spring);
  const std::array<double, 2> two{};
  CHECK_THROWS_AS(run->begin(two, two, 0), Error);
}
