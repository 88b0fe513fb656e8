// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall jump` as a user meets it: what it says, its JSON and CSV, its exit codes.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "analysis/algebra/rational.hpp"
#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE("jump answers first, in the user's unit, and says what is rounded") {
  const CommandRun o = run("jump --height 40cm --dt 0.02");
  CHECK(o.code == 0);
  CHECK(o.error.empty());
  CHECK(contains(
      o.out, "A jump to 40 cm falls ≈ 2.762010199 cm short: its highest frame, 14, is at ≈ 37.23798980 cm."));
  CHECK(contains(o.out, "≈ +0.1521019888 mm"));
  CHECK(contains(o.out, "+2.7468 cm"));
  CHECK(contains(o.out, "H > 1.962 mm"));
  CHECK(contains(o.out, "½ g dt"));
  CHECK(contains(o.out, "40601/14000 exactly"));
  CHECK(contains(o.out, "2.9000711 = 0x1.733588p+1"));
}

TEST_CASE("plain ASCII is plain ASCII") {
  const CommandRun o = run("jump --height 1.7m --ascii");
  CHECK(o.code == 0);
  CHECK(contains(o.out, "A jump to 1.7 m falls ~ 5.727052377 cm short"));
  for (const char c : o.out) CHECK(static_cast<unsigned char>(c) < 128);
}

TEST_CASE("jump says when a body goes too high, and when it stays on the ground") {
  CHECK(contains(run("jump explicit-euler --height 40cm").out, "goes ≈ 2.840846215 cm too high"));
  const CommandRun low = run("jump --height 1.962mm");
  CHECK(low.code == 0);
  CHECK(contains(low.out, "A jump to 1.962 mm does not leave the ground"));
  CHECK(contains(run("jump drift-kick --height 1mm").out, "Every jump leaves the ground"));
}

TEST_CASE("the JSON has the fields that other programs rely on") {
  const auto json = json_of("jump --height 40cm");
  CHECK(json["schema"] == "shortfall.jump/1");
  CHECK(json["integrator"] == "symplectic-euler");
  CHECK(json["dt"] == "1/50");
  CHECK(json["g"] == "981/100");
  CHECK(json["target"] == "2/5");
  CHECK(json["launch_velocity"]["formula"] == "sqrt(981/125)");
  CHECK(json["shortfall"]["total"]["decimal"].get<std::string>().starts_with("0.02762010198878"));
  CHECK(json["shortfall"]["total"]["digits"] == 25);
  CHECK(json["shortfall"]["method"] == "6867/250000");
  CHECK(json["shortfall"]["sampling"]["decimal"].get<std::string>().starts_with("0.000152101988787"));
  CHECK(json["ideal_time_height"]["decimal"].get<std::string>().starts_with("0.371985717928"));
  CHECK(json["parabola_top"]["decimal"].get<std::string>().starts_with("0.372476217928"));
  CHECK(json["best_frame"]["n"] == 14);
  CHECK(json["best_frame"]["height"]["decimal"].get<std::string>().starts_with("0.372379898011"));
  CHECK(json["correction"]["launch"] == "981/10000");
  CHECK(json["correction"]["formula"] == "1/2*g*h");
  CHECK(json["corrected"]["best_frame"]["n"] == 14);
  CHECK(json["corrected"]["shortfall"]["method"] == "0");
  CHECK(json["corrected"]["exact_at_every_frame"] == true);
  CHECK(json["on_frame"]["launch"] == "40601/14000");
  CHECK(json["on_frame"]["n"] == 14);
  CHECK(json["on_frame"]["height"] == "2/5");
  CHECK(json["on_frame"]["shortfall"] == "0");
  CHECK(json["on_frame"]["binary32"]["launch"]["format"] == "binary32");
  CHECK(json["on_frame"]["binary32"]["miss_ulp"] == "0");
  CHECK(json["lift_off_height"] == "981/500000");
}

TEST_CASE("below the lift-off height the best frame is {0, 0}") {
  const auto json = json_of("jump --height 1mm");
  CHECK(json["best_frame"]["n"] == 0);
  CHECK(json["best_frame"]["height"] == "0");
  CHECK(json["lifts_off"] == false);
  CHECK(json["shortfall"]["total"] == "1/1000");
}

TEST_CASE("a time step is a step or a rate, and g and substeps are honoured") {
  CHECK(json_of("jump velocity-verlet --height 1.7 --dt 50Hz")["dt"] == "1/50");
  CHECK(json_of("jump velocity-verlet --height 1.7 --dt 20ms")["correction"]["launch"] == "0");
  CHECK(json_of("jump --height 1.7 --substeps 4")["correction"]["formula"] == "1/8*g*h");
  CHECK(json_of("jump --height 1.7 --g 1.62")["correction"]["launch"] == "81/5000");
  // 1/60f is a rational of its own: the correction is exact for it.
  CHECK(json_of("jump --height 1.7 --dt 1/60f")["dt"] ==
        Rational::from_double(static_cast<double>(1.0F / 60.0F)).str());
}

TEST_CASE("a sweep is one line a height in CSV, a list in JSON, a table for people") {
  const CommandRun csv = run("jump --height 1mm:100m:log:50 --csv");
  CHECK(csv.code == 0);
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') == 51);
  CHECK(csv.out.starts_with("target_m,launch_m_per_s,best_frame,best_height_m,shortfall_m,"));
  CHECK(contains(csv.out, "\n100,44.294469180700202,225,99.557411313150"));
  CHECK(json_of("jump --height 1:2:lin:3")["jumps"].size() == 3);
  CHECK(json_of("jump --height 1:2:lin:3")["jumps"][1]["target"] == "3/2");
  CHECK(contains(run("jump --height 1mm:10m:log:5").out, "≈ 0.9561846440 m"));
}

TEST_CASE("jump --lang prints code, with or without a height") {
  CHECK(contains(run("jump --lang csharp").out, "public static float LaunchVelocity("));
  CHECK(contains(run("jump --lang js --height 1").out, "function launchVelocity("));
  CHECK(run("jump --lang cobol").code == 2);
}

TEST_CASE("bad input is refused with one sentence and exit code 2") {
  for (const char* arguments : {"",
                                "--height 0",
                                "--height -1",
                                "--height 1/0",
                                "--height 40cmm",
                                "--height 1kg",
                                "--height 1s",
                                "--height cm",
                                "--height ''",
                                "--height 1e999999999",
                                "--height nan",
                                "--height inf",
                                "--height 1 --dt 0",
                                "--height 1 --dt -1/50",
                                "--height 1 --dt 1/0",
                                "--height 1 --dt 1m",
                                "--height 1 --dt 0Hz",
                                "--height 1 --g 0",
                                "--height 1 --g -9.81",
                                "--height 1 --g x",
                                "--height 1 --substeps 0",
                                "--height 1 --substeps 1.5",
                                "--height 1 --substeps 100000",
                                "--height 1 --param beta=1",
                                "--height 1 --param beta",
                                "--height 1 no-such-integrator",
                                "--hieght 1",
                                "--height 1:2:lin:1",
                                "--height 1:2:3",
                                "--height 2:0:log:3",
                                "--height 1:2:lin:1000000000"}) {
    CAPTURE(arguments);
    const CommandRun o = run(std::string("jump ") + arguments);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(o.error.starts_with("shortfall: "));
    CHECK(std::count(o.error.begin(), o.error.end(), '\n') == 1);
  }
}

TEST_CASE("the messages name the culprit") {
  CHECK(contains(run("jump --height 40cmm").error, "unknown unit 'cmm'"));
  CHECK(contains(run("jump --height 1/0").error, "division by zero"));
  CHECK(contains(run("jump --hieght 1").error, "did you mean '--height'?"));
  CHECK(contains(run("jump").error, "--height is required"));
}

TEST_CASE("an integrator file with a mistake is exit code 3, a flight without an end 4, a full disk 5") {
  const Folder folder;
  folder.write("wrong.integrator", "integrator wrong\nstep\n  x = x + v\n");
  folder.write("floating.integrator", "integrator floating\nstep\n  x = x + h*v\n");
  folder.write("damped.integrator",
               "integrator damped\n  param c : 1/T = 1/10\nstep\n  v = (v + h*a(x, v, t))*(1 - c*h)\n"
               "  x = x + h*v\n");
  CHECK(folder.run("jump wrong.integrator --height 1").code == 3);
  CHECK(folder.run("jump floating.integrator --height 1").code == 4);
  CHECK(folder.run("jump damped.integrator --height 1 --lang python").code == 4);
  const CommandRun damped = folder.run("jump damped.integrator --height 1");
  CHECK(damped.code == 0);
  CHECK(contains(damped.out, "does not exist"));
  CHECK(folder.run("jump damped.integrator --height 1 --param c=0").out.find("½ g dt") != std::string::npos);
  CHECK(folder.run("jump --height 1 -o no/such/folder").code == 5);
  CHECK(run("jump --height 1 -o /dev/full").code == 5);
  CHECK(folder.run("jump --height 1 -o jump.txt").code == 0);
  CHECK(contains(folder.text("jump.txt"), "A jump to 1 m falls"));
}

}  // namespace
}  // namespace shortfall
