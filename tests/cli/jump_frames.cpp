// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall jump --dt-file` as a user meets it: what it says, its JSON and CSV, its exit codes.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "analysis/algebra/rational.hpp"
#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

const std::string kExample = std::string(SHORTFALL_SOURCE_DIR) + "/examples/frames.csv";

TEST_CASE("jump over frames answers first, then says why, that no launch helps, and what does") {
  const Folder folder;
  folder.write("frames.csv", "dt [ms]\n20\n20\n50\n20\n");
  const CommandRun o = folder.run("jump --height 40cm --dt-file frames.csv --repeat");
  CHECK(o.code == 0);
  CHECK(o.error.empty());
  // By hand: 0.26 s up to frame 10, squares 8*0.0004 + 2*0.0025 s^2, and g/2 of that is lost.
  CHECK(contains(o.out, "falls ≈ 4.342766613 cm short: its highest frame, 10, t = 0.26 s,"));
  CHECK(contains(o.out, "+4.0221 cm "));
  CHECK(contains(o.out,
                 "symplectic-euler, frames of frames.csv, g = 9.81 m/s² downwards\n"
                 "4 frames of 20 ms to 50 ms, column 'dt [ms]', repeated\n"));
  CHECK(contains(o.out, "shortfall    x(t) − xₙ = −½ a Σ[k=1..n] hₖ²   after steps h₁, ..., hₙ"));
  CHECK(contains(o.out, "no launch repairs it, for what it needs depends on frames that are still to come:"));
  CHECK(contains(o.out, "x += −½ a h² at the end of each frame: exact for every list (proved)"));
  CHECK(contains(o.out, "velocity-verlet"));
  CHECK(contains(o.out, "dt = 0.02 s from an accumulator, launched with sqrt(2 g H) + ½ g dt"));
  const CommandRun verlet = folder.run("jump velocity-verlet --height 40cm --dt-file frames.csv --repeat");
  CHECK(contains(verlet.out, "none needed: every frame of every list is on the exact parabola (proved)"));
  CHECK_FALSE(contains(verlet.out, "What does"));
  const CommandRun two_step = folder.run("jump AB2 --height 40cm --dt-file frames.csv --repeat");
  CHECK(contains(two_step.out, "depends on v_prev, which an earlier step has left behind"));
  CHECK(contains(two_step.out, "falls short by −½ h₁ h₂ a + ½ h₂² a"));
  const CommandRun ascii = folder.run("jump --height 40cm --dt-file frames.csv --repeat --ascii");
  CHECK(ascii.code == 0);
  for (const char c : ascii.out) CHECK(static_cast<unsigned char>(c) < 128);
}

TEST_CASE("the JSON of a jump over frames adds up, frame by frame") {
  const Folder folder;
  const CommandRun o = folder.run("jump --height 1.7 --dt-file " + kExample + " --json");
  REQUIRE(o.code == 0);
  const auto json = nlohmann::json::parse(o.out);
  CHECK(json["schema"] == "shortfall.jump/1");
  CHECK(json["dt"].is_null());
  CHECK(json["correction"]["launch"].is_null());
  const auto& frames = json["frames"];
  CHECK(frames["kind"] == "steps");
  CHECK(frames["unit"] == "ms");
  CHECK(frames["count"] == 120);
  CHECK(frames["law"]["shortfall"] == "-1/2*a*sum(k, 1, n, h_k^2)");
  CHECK(frames["repairs"]["term"]["add"] == "-1/2*a*h^2");
  CHECK(frames["repairs"]["term"]["exact_at_every_frame"] == true);
  Rational t, squares;
  for (const auto& f : frames["list"]) {
    const Rational h = Rational::parse(f["h"].get<std::string>());
    t += h;
    squares += h * h;
    CHECK(Rational::parse(f["t"].get<std::string>()) == t);
    CHECK(Rational::parse(f["shortfall"].get<std::string>()) == Rational(981, 200) * squares);
    if (f["n"] == json["best_frame"]["n"]) CHECK(f["shortfall"] == json["shortfall"]["method"]);
  }
  const auto& example = frames["launch"]["counter_example"];
  CHECK(example["one"]["t"] == example["other"]["t"]);
  CHECK(example["one"]["needed"] != example["other"]["needed"]);
  bool verlet = false, euler = true;
  for (const auto& step : frames["repairs"]["steps"]) {
    if (step["integrator"] == "velocity-verlet") verlet = step["exact"];
    if (step["integrator"] == "explicit-euler") euler = step["exact"];
  }
  CHECK(verlet);
  CHECK_FALSE(euler);
}

TEST_CASE("the CSV has one line a frame") {
  const Folder folder;
  folder.write("frames.csv", "0.02\n0.05\n0.02\n");
  const CommandRun o = folder.run("jump --height 40cm --dt-file frames.csv --repeat --csv");
  CHECK(o.code == 0);
  CHECK(o.out.starts_with("n,t_s,h_s,height_m,exact_height_m,shortfall_m\n0,0,0,0,0,0\n1,0.02,0.02,"));
  CHECK(contains(o.out, "\n2,0.07,0.05,"));
  CHECK(contains(o.out, ",0.0142245\n"));  // g/2 (0.02^2 + 0.05^2)
}

TEST_CASE("the corrected step as code") {
  const Folder folder;
  const std::string frames = "--height 1 --dt-file " + kExample;
  CHECK(contains(folder.run("jump " + frames + " --lang python").out, "x = x - 0.5 * (dt * dt) * a"));
  CHECK(contains(folder.run("jump " + frames + " --lang rust").out, "x = x - 0.5 * (dt * dt) * a;"));
  CHECK(folder.run("jump velocity-verlet " + frames + " --lang js").code == 0);
  const CommandRun none = folder.run("jump AB2 " + frames + " --lang python");
  CHECK(none.code == 4);
  CHECK(contains(none.error, "there is no term that makes every step exact"));
  CHECK(none.out.empty());
}

TEST_CASE("seconds that look like milliseconds are noticed") {
  const Folder folder;
  folder.write("frames.csv", "16.7\n16.6\n");
  const CommandRun o = folder.run("jump --height 40km --dt-file frames.csv --repeat");
  CHECK(o.code == 0);
  CHECK(contains(o.out, "for milliseconds begin it with the line: dt [ms]"));
}

TEST_CASE(
    "a list that is over too soon says how much is missing; one that is over while the body falls answers") {
  const Folder folder;
  folder.write("short.csv", "0.1\n0.1\n");
  const CommandRun o = folder.run("jump --height 1 --dt-file short.csv");
  CHECK(o.code == 3);
  CHECK(o.out.empty());
  // The top of a jump to 1 m is at sqrt(2/9.81) = 0.451524 s.
  CHECK(o.error ==
        "short.csv:2:1: the list is over after 2 frames, at t = 0.200000 s (rounded), while the body still "
        "rises; the exact motion is at its top 0.251524 s (rounded) later. Add frames, or say --repeat to "
        "begin the list anew\n");
  folder.write("falling.csv", "0.1\n0.1\n0.1\n0.1\n0.1\n0.1\n");
  const CommandRun falling = folder.run("jump --height 1 --dt-file falling.csv");
  CHECK(falling.code == 0);
  CHECK(contains(falling.out, "no later frame is higher (proved)"));
}

TEST_CASE("bad files are refused with one sentence: exit code 3, or 5 when they cannot be read") {
  const Folder folder;
  const auto refused = [&](const std::string& text) {
    folder.write("bad.csv", text);
    const CommandRun o = folder.run("jump --height 1 --dt-file bad.csv");
    CHECK(o.code == 3);
    CHECK(o.out.empty());
    CHECK(o.error.starts_with("bad.csv:"));
    return o.error.substr(0, o.error.find('\n'));
  };
  CHECK(refused("") == "bad.csv:1:1: there is no step in it: the file is empty");
  CHECK(refused("n,dt [ms]\n1,16\n2,0\n") == "bad.csv:3:3: the step '0' is 0; a frame takes longer than 0 s");
  CHECK(refused("0.1\n-0.1\n") == "bad.csv:2:1: the step '-0.1' is negative; a frame takes longer than 0 s");
  CHECK(contains(refused("time\n0\n1\n1\n"), "bad.csv:4:1: the time stamp '1' does not advance"));
  CHECK(refused("0.1\nnan\n") == "bad.csv:2:1: 'nan' is not a number");
  CHECK(contains(refused(std::string("\x7F"
                                     "ELF\0\0",
                                     6)),
                 "this is no text"));
  const CommandRun missing = folder.run("jump --height 1 --dt-file none.csv");
  CHECK(missing.code == 5);
  CHECK(missing.error == "shortfall: cannot read the file 'none.csv'\n");
  CHECK(folder.run("jump --height 1 --dt-file .").code == 5);
}

TEST_CASE("options that do not go together are usage: exit code 2") {
  const Folder folder;
  for (const char* arguments :
       {"--height 1:2:lin:3 --dt-file F", "--height 1 --repeat", "--dt-file F", "--dt-file F --lang python",
        "--height 1 --dt-file", "--height 1 --dt-file F --dt 0", "--height 1 --dt-file F --lang cobol"}) {
    CAPTURE(arguments);
    std::string text = arguments;
    if (const auto at = text.find('F'); at != std::string::npos) text.replace(at, 1, kExample);
    const CommandRun o = folder.run("jump " + text);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(o.error.starts_with("shortfall: "));
    CHECK(std::count(o.error.begin(), o.error.end(), '\n') == 1);
  }
}

}  // namespace
}  // namespace shortfall
