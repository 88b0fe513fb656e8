// SPDX-License-Identifier: GPL-3.0-or-later
// What engines do to a jump at 50 Hz without damping, and which launch repairs it.
#include <doctest/doctest.h>

#include <map>
#include <set>
#include <string>

#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall::engines {
namespace {

Jump jumped(const Program& program, const Rational& height) {
  JumpQuestion question{.height = height, .binary32_frames = 0};
  question.parameters["c"] = Rational(0);
  return jump(program, question);
}

std::string centimetres(const Jump& j) { return (j.shortfall.total * Surd(100)).decimal(3); }

/// How much too low in centimetres, from heights of 40 cm and 170 cm, and the correction in units of g dt.
struct Row {
  std::string low, high;
  Rational correction;
};

const Row kKickFirst{"2.762", "5.727", Rational(1, 2)};
const Row kFourSubsteps{"0.702", "1.460", Rational(1, 8)};
const Row kDriftFirst{"-2.841", "-5.824", Rational(-1, 2)};
const Row kExact{"0.015", "0.037", Rational(0)};

Row expected(const std::string& name) {
  const std::set<std::string> four = {"rapier", "box2d", "physx-tgs-external-forces"};
  if (four.contains(name)) return kFourSubsteps;
  if (name == "chipmunk") return kDriftFirst;
  if (name == "mujoco-rk4") return kExact;
  return kKickFirst;
}

TEST_CASE("the same jump in every engine: the famous g dt/2 is right in most of them and wrong in five") {
  int five = 0;
  for (const Program& program : catalogue()) {
    if (family(program) != "engines") continue;
    CAPTURE(program.name);
    const Row row = expected(program.name);
    const Jump low = jumped(program, Rational(2, 5)), high = jumped(program, Rational(17, 10));
    CHECK(centimetres(low) == row.low);
    CHECK(centimetres(high) == row.high);
    const Rational unit = low.g * low.dt;
    CHECK(low.correction.value(low.g) == row.correction * unit);
    REQUIRE(low.corrected);
    CHECK(low.corrected->exact_at_every_frame);
    five += row.correction != Rational(1, 2);
  }
  CHECK(five == 5);
}

TEST_CASE("Jolt with four collision steps jumps as Rapier does") {
  JumpQuestion question{.height = Rational(2, 5), .binary32_frames = 0};
  question.parameters = {{"c", Rational(0)}, {"N", Rational(4)}};
  CHECK(centimetres(jump(find_integrator("jolt"), question)) == "0.702");
}

TEST_CASE("Godot's default damping costs a jump of 10 m 101 cm") {
  const Jump j = jump(find_integrator("godot"), {.height = 10, .binary32_frames = 0});
  CHECK((j.shortfall.total * Surd(100)).decimal(0) == "101");
}

}  // namespace
}  // namespace shortfall::engines
