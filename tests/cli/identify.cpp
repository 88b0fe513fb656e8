// SPDX-License-Identifier: GPL-3.0-or-later
// identify, port and guard as a user asks for them: reports, pictures, code, exit codes, and what is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

/// A fall in steps of 1/50 s, 10 m/s up: the velocity is changed before the position moves, and loses the
/// share c h of what it was; every number with all its digits.
std::string damped_fall(int rows, double damping) {
  std::string text = "time,y,vy\n";
  double y = 0, v = 10;
  const double h = 0.02;
  for (int n = 0; n < rows; ++n) {
    char line[100];
    std::snprintf(line, sizeof line, "%.12g,%.17g,%.17g\n", n * h, y, v);
    text += line;
    v = v * std::pow(1 - damping, h) + h * -9.81;
    y = y + h * v;
  }
  return text;
}

TEST_CASE("identify names the map, its numbers, and what repairs it") {
  const Folder folder;
  folder.write("log.csv", damped_fall(90, 0.5));
  const CommandRun told = folder.run("identify log.csv");
  CHECK(told.code == 0);
  CHECK(contains(told.out, "90 rows, binary64, with velocities, dt = 1/50 s (time stamps)"));
  CHECK(contains(told.out, "cannon-es"));
  CHECK(contains(told.out, "c = 0.5, a_y = -9.81"));
  const auto json = nlohmann::json::parse(folder.run("identify log.csv --json").out);
  CHECK(json["schema"] == "shortfall.identify/1");
  CHECK(json["kind"] == "map");
  CHECK(json["candidates"][0]["exact"] == true);
  // Other conventions do the same with numbers that nobody would type; the simple ones come first.
  CHECK(json["candidates"][0]["parameters"]["c"] == "1/2");
  CHECK(json["identifiable"] == false);
  CHECK(json["repair"].is_null());
  const std::string recorded =
      "identify " SHORTFALL_SOURCE_DIR "/tests/data/recordings/rapier3d/force_v0_2_0_dt1-50_g9.81_d0.5.csv";
  const CommandRun one = run(recorded);
  const std::string repair = "shortfall correct rapier --substeps 4 --param c=1/2 --dt 1/50";
  CHECK(contains(one.out, "Identified: no other map that is known makes this log."));
  CHECK(contains(one.out, "What repairs it (" + repair + ")"));
  CHECK(contains(one.out, "exact on every frame"));
  CHECK(json_of(recorded)["repair"] == repair);
}

TEST_CASE("identify draws what is left, and writes the repair as code") {
  const Folder folder;
  folder.write("log.csv", damped_fall(90, 0));
  const CommandRun drawn = folder.run("identify log.csv --plot left.svg");
  if (drawn.code == 5) {  // gnuplot is not here
    CHECK(contains(drawn.error, "gnuplot"));
  } else {
    CHECK(drawn.code == 0);
    CHECK(contains(folder.text("left.svg"), "recorded minus computed"));
  }
  CHECK(folder.run("identify log.csv --plot left.bmp").code == 2);
  CHECK_FALSE(folder.has("left.bmp"));
  folder.write("damped.csv", damped_fall(90, 0.5));
  const CommandRun code = folder.run("identify damped.csv --lang python");
  CHECK(code.code == 4);  // several conventions of damping make it
  const CommandRun kit =
      run("identify " SHORTFALL_SOURCE_DIR
          "/tests/data/recordings/rapier3d/force_v0_2_0_dt1-50_g9.81_d0.5.csv --lang python");
  CHECK(kit.code == 0);
  CHECK(contains(kit.out, "class ExactDrag:"));
  // Two ways of adding up the same fall are different maps: no code then.
  const CommandRun several = folder.run("identify log.csv --lang python");
  CHECK(several.code == 4);
  CHECK(contains(several.error, "different maps make"));
}

TEST_CASE("identify refuses what is no log, each in one sentence with its place") {
  const Folder folder;
  const auto refused = [&](const std::string& text, int code, const std::string& words) {
    folder.write("bad.csv", text);
    const CommandRun o = folder.run("identify bad.csv");
    CAPTURE(text);
    CAPTURE(o.error);
    CHECK(o.code == code);
    CHECK(contains(o.error, words));
    CHECK(o.out.empty());
  };
  refused("", 3, "the file is empty");
  refused("\x01\x02 y\n0,1\n", 3, "this is no text");
  refused("time,y\n0,1\n", 3, "row");
  refused("time,y\n0,1\n0.02,1\n0.04,1\n0.06,1\n0.08,1\n", 4, "the body does not move");
  refused("time,y\n0,1\n0.02,nan\n0.04,3\n0.06,4\n", 3, "bad.csv:3:");
  refused("time,y\n0,1\n0.04,2\n0.02,3\n0.06,4\n", 3, "bad.csv:4:");
  refused("time,y\n0,1\n0.02,two\n0.04,3\n0.06,4\n", 3, "two");
  CHECK(folder.run("identify nowhere.csv").code == 5);
  CHECK(folder.run("identify").code == 2);
  folder.write("good.csv", damped_fall(20, 0));
  CHECK(folder.run("identify good.csv --dt soon").code == 2);
}

TEST_CASE("identify --with: an integrator of the user is a candidate as well" *
          doctest::test_suite("thorough")) {
  const Folder folder;
  // A step that nobody else has: the position moves with a mean of three quarters of the new velocity.
  std::string log = "time,y,vy\n";
  double y = 0, v = 10;
  for (int n = 0; n < 60; ++n) {
    char line[100];
    std::snprintf(line, sizeof line, "%.12g,%.6f,%.6f\n", n * 0.02, y, v);
    log += line;
    const double before = v;
    v = v - 0.02 * 9.81 - 0.01 * v;
    y = y + 0.02 * (0.25 * before + 0.75 * v);
  }
  folder.write("log.csv", log);
  folder.write("mine.integrator",
               "integrator mine\n  param c : 1/T = 1/2\nstep\n  u = v + h*a(x, v, t) - c*h*v\n"
               "  x = x + h*(1/4*v + 3/4*u)\n  v = u\n");
  CHECK_FALSE(contains(folder.run("identify log.csv --all").out, "mine"));
  const CommandRun found = folder.run("identify log.csv --with mine.integrator");
  CAPTURE(found.out);
  CHECK(found.code == 0);
  CHECK(contains(found.out, "mine "));
  // What repairs it is asked of the user's file, which no other name finds.
  CHECK_FALSE(contains(found.out, "unknown integrator"));
  const auto repair = nlohmann::json::parse(folder.run("identify log.csv --with mine.integrator --json").out);
  CHECK(contains(repair["repair"].dump(), "mine.integrator"));
  CHECK(folder.run("identify log.csv --with nowhere.integrator").code == 5);
}

TEST_CASE("identify --by-dt: order, limit and method from peaks") {
  const CommandRun o = run("identify --by-dt 30Hz:165px 60Hz:150px 120Hz:142.5px");
  CHECK(o.code == 0);
  CHECK(contains(o.out, "order   1\n"));
  CHECK(contains(o.out, "limit   135 px"));
  CHECK(contains(o.out, "drifts before it kicks"));
  CHECK(run("identify --by-dt 30Hz:165px 60Hz:150cm").code == 2);
  CHECK(run("identify --by-dt 30Hz").code == 2);
}

TEST_CASE("port gives numbers that make the same motion, and code") {
  const auto json =
      nlohmann::json::parse(run("port physx rapier --dt 60Hz --height 1.7 --param c=0.5 --json").out);
  CHECK(json["exact"] == true);
  CHECK(json["error"].get<double>() < 1e-12);
  // rapier with four substeps needs a larger damping number than PhysX, which scales by 1 - c h.
  CHECK(json["ported"]["c"].get<double>() > 0.5);
  const CommandRun code = run("port physx rapier --dt 60Hz --height 1.7 --param c=0.5 --lang python");
  CHECK(code.code == 0);
  CHECK(contains(code.out, "def ported_launch"));
  CHECK(run("port physx rapier --dt 60Hz").code == 2);
  CHECK(run("port physx nowhere --dt 60Hz --height 1").code == 2);
}

TEST_CASE("guard passes on the map that made a log and fails on another, with a reason") {
  const Folder folder;
  folder.write("log.csv", damped_fall(90, 0.5));
  const CommandRun same = folder.run("guard log.csv cannon-es");
  CHECK(same.code == 0);
  CHECK(contains(same.out, "cannon-es reproduces rows 0 to 89 of log.csv to the last bit"));
  const CommandRun other = folder.run("guard log.csv jolt --substeps 2");
  CHECK(other.code == 1);
  CHECK(contains(other.out, "does not reproduce log.csv"));
  // A damping number that was given must be the one that is found.
  CHECK(folder.run("guard log.csv cannon-es --param c=0.5").code == 0);
  const CommandRun changed = folder.run("guard log.csv cannon-es --param c=0.3");
  CHECK(changed.code == 1);
  CHECK(contains(changed.out, "with another damping number than c = 3/10: c = 0.5, a_y = -9.81"));
  const std::string recorded =
      "guard " SHORTFALL_SOURCE_DIR "/tests/data/recordings/physx/velocity_h1.7_dt1-50_g9.81_d0.5.csv physx";
  CHECK(run(recorded + " --param c=0.5").code == 0);
  CHECK(run(recorded + " --param c=0").code == 1);
  const auto json = nlohmann::json::parse(folder.run("guard log.csv jolt --substeps 2 --json").out);
  CHECK(json["holds"] == false);
}

}  // namespace
}  // namespace shortfall
