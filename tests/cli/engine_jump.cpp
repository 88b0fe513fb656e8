// SPDX-License-Identifier: GPL-3.0-or-later
// Jumps of engines as a user meets them.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace shortfall {
namespace {

struct Outcome {
  int code;
  std::string out;  ///< and messages
};

Outcome run(const std::string& arguments) {
  std::FILE* pipe = ::popen((std::string(SHORTFALL_BINARY) + " " + arguments + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe))
    text.append(part.data(), size);
  return {WEXITSTATUS(::pclose(pipe)), text};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

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

}  // namespace
}  // namespace shortfall
