// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/reference.hpp"

using namespace shortfall;

namespace {

const std::string kForce = "kind = \"constant\"\nacceleration = 1";
const std::string kGood =
    "until = 1\ndt = 0.1\n[[body]]\nposition = 1\n[[force]]\nkind = \"constant\"\nacceleration = "
    "1\n[[observable]]\n"
    "kind = \"position\"\ntolerance = 1\n";

/// "line:column what".
std::string scene_refusal(const std::string& text) {
  try {
    scene_of(text, "s.toml");
  } catch (const SyntaxError& e) {
    return std::to_string(e.line()) + ":" + std::to_string(e.column()) + " " + e.what();
  }
  return "accepted";
}

std::string with(std::string from, const std::string& what, const std::string& other) {
  const std::size_t at = from.find(what);
  REQUIRE(at != std::string::npos);
  return from.replace(at, what.size(), other);
}

struct Wrong {
  std::string text;
  std::string expected;  ///< a part of the message
};

}  // namespace

TEST_CASE("every shipped scene is read, and has a true value for everything it looks at") {
  std::set<std::string> seen;
  for (const auto& entry : std::filesystem::directory_iterator(SHORTFALL_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().string());
    const Scene scene = read_scene(entry.path().string());
    CHECK(!scene.title.empty());
    seen.insert(scene.name);
    CHECK(scene.coordinates() > 0);
  }
  CHECK(seen.size() >= 10);
  for (const char* name :
       {"jump", "jump-godot", "jump-rapier", "grenade", "swing", "spring-door", "car-suspension", "moon",
        "outer-solar-system", "pendulum-clock", "stiff-spring", "feather", "kepler", "atlas"})
    CHECK_MESSAGE(seen.contains(name), name);
}

TEST_CASE("numbers are exact as they are written") {
  const Scene scene = scene_of(
      with(with(kGood, "position = 1", "position = 0.1"), "tolerance = 1", "tolerance = 1_000.25e-3"),
      "s.toml");
  CHECK(scene.bodies[0].position[0] == Rational(1, 10));
  CHECK(scene.observables[0].tolerance == Rational(100025, 100000));
  CHECK(scene_of(with(kGood, "dt = 0.1", "dt = \"60 Hz\""), "s.toml").step == Rational(1, 60));
  CHECK(scene_of(with(kGood, "dt = 0.1", "dt = \"20 ms\""), "s.toml").step == Rational(1, 50));
  CHECK(scene_of(with(kGood, "acceleration = 1", "acceleration = \"1/3 m/s^2\""), "s.toml")
            .forces[0]
            .numbers[0] == Rational(1, 3));
}

TEST_CASE("a force with a mass in its unit is divided by the body's") {
  const Scene scene = scene_of(with(with(kGood, "position = 1", "position = 1\nmass = \"4 kg\""), kForce,
                                    "kind = \"spring\"\nstiffness = \"20 N/m\"\ndamping = \"2 kg/s\""),
                               "s.toml");
  CHECK(scene.forces[0].numbers[0] == Rational(5));
  CHECK(scene.forces[0].numbers[1] == Rational(1, 2));
}

TEST_CASE("bad scenes are refused with line, column and a sentence") {
  const Wrong all[] = {
      {"until = ", "1:"},
      {"", "needs a key 'until'"},
      {"\xff\xfe", ""},
      {with(kGood, "position = 1", "positoin = 1"),
       "4:1 s.toml:4:1: unknown key 'positoin' in a body; did you mean 'position'?"},
      {with(kGood, "kind = \"constant\"", "kind = \"constat\""), "did you mean 'constant'?"},
      {with(kGood, "kind = \"position\"", "kind = \"positions\""), "unknown observable 'positions'"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"x*acos(x)\""),
       "acceleration: the force of a scene cannot call acos; it can call sqrt, exp, pow, max, min, cos"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"abs(x)\""),
       "acceleration: there is no function 'abs'; there are sqrt, exp, pow, max, min, cos, sin, cosh, sinh, "
       "log"},
      {with(kGood, "position = 1", "position = \"1 s\""), "position has the dimension L"},
      {with(kGood, "position = 1", "position = \"1 parsec\""), "unknown unit 'parsec'"},
      {with(kGood, "position = 1", "position = [1, 2]"), "position has 1 component here, not 2"},
      {with(kGood, "position = 1", "position = inf"), "position"},
      {with(kGood, "position = 1", "position = true"), "position is a number"},
      {with(kGood, "dt = 0.1", "dt = 0"), "dt must be greater than 0"},
      {with(kGood, "dt = 0.1", "dt = \"0 Hz\""), "0 Hz is no step"},
      {with(kGood, "dt = 0.1", "dt = -1"), "dt must be greater than 0"},
      {with(kGood, "dt = 0.1", "dt = 2"), "dt is longer than the scene"},
      {with(kGood, "until = 1", "until = nan"), "until"},
      {with(kGood, "tolerance = 1", "tolerance = 0"), "tolerance must be greater than 0"},
      {with(kGood, "tolerance = 1", "tolerance = \"1 kg\""), "tolerance has the dimension L"},
      {with(kGood, "tolerance = 1", ""), "needs a key 'tolerance'"},
      {kGood + "[[observable]]\nkind = \"position\"\ntolerance = 2\n", "contradictory tolerances"},
      {kGood + "[[observable]]\nkind = \"position\"\ntolerance = 1\n", "there are two observables"},
      {with(kGood, "tolerance = 1", "tolerance = 1\nat = 3"), "at is after the end of the scene"},
      {kGood + "[[observable]]\nkind = \"period\"\nevent = \"low\"\ntolerance = 1\n",
       "there is no event 'low'"},
      {kGood + "[budget]\nformats = [\"f31\"]\n", "f31"},
      {kGood + "[budget]\nintegrator = \"rk5\"\n", "rk5"},
      {kGood + "[budget]\nintegrator = \"godot\"\nparameters = { z = 1 }\n", "z"},
      {kGood + "[budget]\nmicroseconds = -1\n", "microseconds"},
      {kGood + "[budget]\nsubsteps = 0\n", "substeps is a whole number from 1 to"},
      {kGood + "naive = \"rk4\"\n", "unknown key 'naive' in an observable"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"-2x\""), "7:"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"-y\""), "unknown name 'y'"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"tan(x)\""), "tan"},
      {with(kGood, kForce, "kind = \"expression\"\nacceleration = \"a(x, vx, t)\""),
       "does not call a(x, v, t)"},
      {with(kGood, kForce, "kind = \"pendulum\"\ngravity = 1\nlength = 1"), "coordinates = \"angles\""},
      {with(kGood, kForce, "kind = \"lorentz\"\nmagnetic = [0, 0, 1]"), "needs a plane or space"},
      {with(kGood, kForce, "kind = \"link\"\nbetween = [\"body 1\", \"body 1\"]\nstiffness = 1"),
       "between two bodies"},
      {with(kGood, "[[body]]\nposition = 1\n", ""), "needs a [[body]]"},
      {with(kGood, "[[body]]", "[body]"), "write [[body]]"},
      {"dimension = 4\n" + kGood, "dimension is a whole number from 1 to 3"},
      {"units = { length = \"s\" }\n" + kGood, "'s' is no unit of length"},
      {"[parameters]\nx = 1\n", "needs a key"},
  };
  for (const Wrong& w : all) {
    CAPTURE(w.text);
    const std::string message = scene_refusal(w.text);
    CAPTURE(message);
    CHECK(message != "accepted");
    CHECK(message.find(w.expected) != std::string::npos);
  }
  CHECK_THROWS_AS(read_scene("/nowhere/scene.toml"), UnreadableFile);
}

TEST_CASE("a scene cut off anywhere is refused or read, never a crash") {
  for (std::size_t length = 0; length < kGood.size(); ++length) {
    try {
      scene_of(kGood.substr(0, length), "cut.toml");
    } catch (const Error&) {
    }
  }
}
