// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/splitting_reading.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;
using Parts = SplittingParts<Rational>;

namespace {

std::string written(const Parts& parts) {
  std::string text;
  for (const auto& [kick, weight] : parts)
    text += std::string(text.empty() ? "" : ", ") + (kick ? "kick " : "drift ") + weight.str();
  return text;
}

/// "start | step | finish", or why not.
std::string read(const Program& program) {
  const SplittingReading reading = splitting_reading(program);
  if (!reading.is_splitting()) return reading.why_not;
  const auto& parts = std::get<KicksAndDrifts<Rational>>(reading.parts);
  return written(parts.start) + " | " + written(parts.step) + " | " + written(parts.finish);
}

std::string read_step(const std::string& step) {
  return read(parse("integrator test\n" + step, "test.integrator"));
}

double value(const Rational& r) { return r.to_double(); }
double value(const Algebraic& a) { return a.to_double(); }
double value(const KnownDigits& d) { return d.ball().to_double(); }

/// Kicks and drifts as the words say, for x'' = -x - x^3 / 2 + t.
struct Body {
  double x = 1, v = Rational(1, 3).to_double(), t = 0;
  template <class Field>
  void move(const SplittingParts<Field>& parts, double h) {
    double covered = 0;
    for (const auto& p : parts) {
      if (p.kick) {
        v += value(p.weight) * h * (-x - x * x * x / 2 + t + covered);
      } else {
        x += value(p.weight) * h * v;
        covered += value(p.weight) * h;
      }
    }
  }
};

}  // namespace

TEST_CASE("integrators of the catalogue are read as the splittings that they are") {
  const std::map<std::string, std::string> known{
      {"symplectic-euler", " | kick 1, drift 1 | "},
      {"symplectic-euler-drift-kick", " | drift 1, kick 1 | "},
      {"velocity-verlet", " | kick 1/2, drift 1, kick 1/2 | "},
      {"position-verlet", " | drift 1/2, kick 1, drift 1/2 | "},
      {"leapfrog", "kick -1/2 | kick 1, drift 1 | kick 1/2"},
      {"stoermer-verlet", "kick -1/2 | kick 1, drift 1 | kick 1/2"},
      {"stoermer-verlet-wrong-start", " | kick 1, drift 1 | kick 1/2"},
      {"ruth3", " | kick 7/24, drift 2/3, kick 3/4, drift -2/3, kick -1/24, drift 1 | "},
      {"box2d-2", " | kick 1, drift 1 | "},
      {"explicit-euler", "no kicks and drifts lead to the new position"},
      {"midpoint", "no kicks and drifts lead to the new position"},
      {"rk4", "no kicks and drifts lead to the position of force evaluation 2"},
      {"implicit-midpoint", "it solves for a stage, while kicks and drifts are explicit"},
      {"newmark", "it solves for a stage, while kicks and drifts are explicit"},
      {"beeman", "it remembers more than a position and a velocity: a_prev"},
      {"adams-bashforth-2", "it remembers more than a position and a velocity: a_prev"}};
  for (const auto& [word, expected] : known) {
    const std::string name = word;
    CHECK_MESSAGE(read(find_integrator(name)) == expected, name);
  }
}

TEST_CASE("every splitting of the catalogue moves as its kicks and drifts do, three steps long") {
  int splittings = 0;
  for (const Program& program : catalogue()) {
    const SplittingReading reading = splitting_reading(program);
    if (!reading.is_splitting()) continue;
    ++splittings;
    Numbers<double> problem;
    problem.force = [](double x, double, double t) { return -x - x * x * x / 2 + t; };
    const Tape tape = lower(undisturbed(program));
    const double h = 0.0625;
    Run run(tape, problem, h);
    Body body;
    run.begin(body.x, body.v, 0);
    std::visit(
        [&](const auto& parts) {
          if constexpr (requires { parts.step; }) {
            CHECK_MESSAGE(parts.time_follows_drifts, program.name);
            body.move(parts.start, h);
            for (int n = 1; n <= 3; ++n) {
              run.step();
              body.move(parts.step, h);
              body.t = n * h;
              Body seen = body;
              seen.move(parts.finish, h);
              const auto [x, v] = run.read_out();
              CHECK_MESSAGE(std::abs(x - seen.x) < 1e-13, program.name);
              CHECK_MESSAGE(std::abs(v - seen.v) < 1e-13, program.name);
            }
          }
        },
        reading.parts);
  }
  CHECK(splittings >= 28);
}

TEST_CASE("numbers of the three kinds are kept apart") {
  const auto kind = [](const std::string& name) {
    return splitting_reading(find_integrator(name)).parts.index();
  };
  CHECK(kind("velocity-verlet") == 1);
  for (const char* name : {"yoshida4", "forest-ruth", "suzuki4", "mclachlan-s4", "mclachlan-atela-3"})
    CHECK(kind(name) == 2);
  for (const char* name : {"yoshida6", "pefrl", "blanes-moan-rkn11"}) CHECK(kind(name) == 3);
  CHECK(splitting_reading(find_integrator("yoshida4")).generator == "r");
  CHECK(splitting_reading(find_integrator("mclachlan-s4")).generator == "sqrt(471)");
}

TEST_CASE("two square roots that share a field are exact; those that do not are known to digits") {
  const std::string one = "splitting\n  kick sqrt(8)/8\n  drift 1\n  kick 1 - sqrt(2)/4\n";
  const auto shared = splitting_reading(parse("integrator test\n" + one, "test.integrator"));
  REQUIRE(shared.parts.index() == 2);
  const auto& step = std::get<KicksAndDrifts<Algebraic>>(shared.parts).step;
  CHECK(step[0].weight + step[2].weight == Algebraic(1));
  const std::string two = "splitting\n  kick sqrt(3)/8\n  drift 1\n  kick 1 - sqrt(2)/4\n";
  CHECK(splitting_reading(parse("integrator test\n" + two, "test.integrator")).parts.index() == 3);
}

TEST_CASE("random splittings are read back from their text, however the step is written") {
  CHECK(rc::check([] {
    const Parts parts = merged(*random::splitting(6));
    RC_PRE(parts.size() > 1);  // without kicks, or without drifts, it is no integrator
    std::string rows = "splitting\n";
    for (const auto& [kick, weight] : parts) rows += (kick ? "  kick " : "  drift ") + weight.str() + "\n";
    RC_ASSERT(read_step(rows) == " | " + written(parts) + " | ");
  }));
}

TEST_CASE(
    "a Nystroem step with kicks 1/6, 2/3, 1/6 at 0, 1/2, 1 is recognised; a wrong number in it is not") {
  const auto step = [](const std::string& last) {
    return "step\n  k1 = a(x, v, t)\n  k2 = a(x + h/2*v + h^2/12*k1, v, t + h/2)\n"
           "  k3 = a(x + h*v + h^2/6*k1 + h^2/3*k2, v, t + h)\n"
           "  x = x + h*v + h^2/6*k1 + " +
           last + "\n  v = v + h/6*(k1 + 4*k2 + k3)\n";
  };
  CHECK(read_step(step("h^2/3*k2")) == " | kick 1/6, drift 1/2, kick 2/3, drift 1/2, kick 1/6 | ");
  CHECK(read_step(step("h^2/4*k2")) == "no kicks and drifts lead to the new position");
}

TEST_CASE("substeps are read through") {
  CHECK(read(substepped(find_integrator("velocity-verlet"), 2)) ==
        " | kick 1/4, drift 1/2, kick 1/2, drift 1/2, kick 1/4 | ");
}

TEST_CASE("a kick at the wrong time is seen") {
  const auto late = splitting_reading(
      parse("integrator test\nstep\n  x = x + h*v\n  v = v + h*a(x, v, t)\n", "test.integrator"));
  REQUIRE(late.is_splitting());
  CHECK_FALSE(std::get<KicksAndDrifts<Rational>>(late.parts).time_follows_drifts);
}

TEST_CASE("a step that damps, or adds a constant power of h, is no splitting") {
  CHECK(read_step("step\n  v = 1/2*v + h*a(x, v, t)\n  x = x + h*v\n") ==
        "it scales a position or a velocity, or adds a position to a velocity");
  CHECK(read_step("step\n  v = v + h*a(x, v, t)\n  x = x + h/2*v\n  v = 3*v\n") ==
        "it scales a position or a velocity, or adds a position to a velocity");
}
