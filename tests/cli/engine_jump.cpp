// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps of engines as a user meets them.
#include <doctest/doctest.h>

#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE("--substeps sets the number of substeps of an engine that has its own") {
  const auto json = nlohmann::json::parse(run("jump rapier --height 1.7 --substeps 8 --json").out);
  CHECK(json["substeps"] == 1);
  CHECK(json["parameters"]["N"] == "8");
  CHECK(json["correction"]["launch"] == "981/80000");  // g dt/16
  CHECK(json["shortfall"]["damping"] == "0");
  CHECK(run("jump rapier --height 1.7 --substeps 8 --param N=3").code == 2);
  const auto wrapped =
      nlohmann::json::parse(run("jump symplectic-euler --height 1.7 --substeps 8 --json").out);
  CHECK(wrapped["substeps"] == 8);
}

TEST_CASE("what drag takes has a part of its own, and limits their frame") {
  const auto godot = nlohmann::json::parse(run("jump godot --height 10m --param c=0.1 --json").out);
  CHECK(godot["drag"] == "1/10");
  CHECK(godot["shortfall"]["damping"]["decimal"].get<std::string>().starts_with("0.86036787"));
  CHECK(godot["correction"]["launch"].is_null());
  CHECK(godot["limit"].is_null());
  const auto box2d = nlohmann::json::parse(run("jump box2d-2 --height 600 --json").out);
  CHECK(box2d["limit"]["frame"] == 1);
  CHECK(contains(run("jump box2d-2 --height 600").out, "'limit move L' acts in frame 1"));
  CHECK(contains(run("jump bullet --height 1.7 --param c=0.1").out, "rounded to 100 digits"));
  CHECK_FALSE(contains(run("jump bullet --height 1.7 --param c=0.1").out, "exactly"));
}

TEST_CASE("all engines, in a table, as CSV and as JSON; and how they are launched") {
  CHECK(contains(run("jump --all-engines --height 1.7").out, "+1.460       -4.352  ⅛ g dt"));
  CHECK(contains(run("jump --all-engines --height 40cm --csv").out, "\nchipmunk,0.4,"));
  CHECK(nlohmann::json::parse(run("jump --all-engines --height 1.7 --json").out)["engines"].size() == 17);
  CHECK(run("jump rapier --all-engines --height 1").code == 2);
  CHECK(run("jump --all-engines --height 1:2:lin:3").code == 2);
  CHECK(run("jump matter-js --height 1 --launch impulse").code == 2);
  CHECK(run("jump physx --height 1 --launch throw").code == 2);
  CHECK(contains(run("jump physx-tgs-external-forces --height 1.7 --launch impulse").out, "does not exist"));
  CHECK(contains(run("correct rapier --height 1.7 --lang rust").out, "0.125 * gravity * dt"));
}

TEST_CASE("a force that is held over frame 1 launches, too") {
  const auto json = json_of("jump rapier --height 1.7 --launch force");
  CHECK(json["launch_by"] == "force");
  CHECK(json["correction"]["launch"].is_null());
  CHECK(json["on_frame"]["height"] == "17/10");
  const CommandRun o = run("jump rapier --height 1.7 --launch force");
  CHECK(contains(o.out, "launched by a force that is held over frame 1"));
  CHECK(contains(o.out, "the force's own frame included"));
  CHECK(contains(run("jump --all-engines --height 1.7 --launch force").out, "held over frame 1"));
  CHECK(run("jump --height 1.7 --launch force --dt-file frames.csv").code == 2);
  CHECK(run("jump physx --height 1.7 --launch force --lang cpp").code == 2);
}

}  // namespace
}  // namespace shortfall
