// SPDX-License-Identifier: GPL-3.0-or-later
// The printed code is compiled and run where its language is installed, and compared with the library's
// numbers.
#include "notebooks-export/code.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/export/languages.hpp"

namespace shortfall {
namespace {

const Rational kG(981, 100), kDt(1, 50);

struct NamedFlight {
  std::string what;
  Flight flight;
};

/// The whole catalogue, some with substeps, and one that nobody would write.
const std::vector<NamedFlight>& flights() {
  static const std::vector<NamedFlight> all = [] {
    std::vector<NamedFlight> list;
    for (const Program& p : catalogue())
      if (family(p) != "engines") list.push_back({p.name, Flight(p, kDt)});
    for (const char* name : {"symplectic-euler", "rk4", "leapfrog", "beeman", "implicit-midpoint"})
      list.push_back({std::string(name) + " with 4 substeps", Flight(find_integrator(name), kDt, 4)});
    const Program odd = parse(
        "integrator odd\n"
        "  param lambda = 1/3\n"
        "  param alpha_m = 1 - lambda\n"
        "  param substep_count = 3\n"
        "  state while : L/T\n"
        "start\n"
        "  top = h*v\n"
        "  while = top/h\n"
        "step\n"
        "  substeps substep_count {\n"
        "    def = v\n"
        "    v = v + h*a(x, v, t)\n"
        "    x = x + h*(lambda*def + alpha_m*v) + 0*h*while\n"
        "    last_speed = v\n"
        "  }\n"
        "  substeps 2 {\n"
        "    unused = h*v\n"
        "    x = x + 0*h*last_speed\n"
        "  }\n"
        "  while = v\n"
        "finish\n"
        "  top = x\n"
        "  x = top + 0*h*v\n",
        "odd.integrator");
    list.push_back({"odd", Flight(odd, kDt)});
    for (const char* name : {"physx", "rapier", "jolt", "bullet", "chipmunk", "mujoco-euler"})
      list.push_back({std::string("the engine ") + name, Flight(find_integrator(name), kDt, 1, {{"c", 0}})});
    list.push_back({"rapier, N = 8", Flight(find_integrator("rapier"), kDt, 1, {{"N", 8}})});
    return list;
  }();
  return all;
}

/// What each flight prints: launch, on-frame launch, highest frame after the library's binary32 launch,
/// self-check (0 or 1); all for a jump of 1.7 m.
void compare_jumps(const std::string& output, bool binary32) {
  std::istringstream in(output);
  const double tolerance = binary32 ? 4e-7 : 1e-14;
  for (const NamedFlight& s : flights()) {
    CAPTURE(s.what);
    const Jump j = jump(s.flight, Rational(17, 10), kG);
    double launch = 0, on_frame = 0, top = 0, check = 0;
    REQUIRE(bool(in >> launch >> on_frame >> top >> check));
    CHECK(launch == doctest::Approx(j.corrected->launch.to_double()).epsilon(tolerance));
    CHECK(on_frame == doctest::Approx(j.on_frame->launch.to_double()).epsilon(tolerance));
    if (binary32)
      CHECK(static_cast<float>(top) == j.binary32->top);
    else
      CHECK(top == doctest::Approx(static_cast<double>(j.binary32->top)).epsilon(1e-5));
    CHECK(check == 1);
  }
}

std::string launch_of(std::size_t k, const char* suffix = "") {
  char text[64];
  std::snprintf(text, sizeof text, "%.9g%s",
                static_cast<double>(jump(flights()[k].flight, Rational(17, 10), kG).binary32->launch),
                suffix);
  return text;
}

/// Whether the flight's launch velocity takes dt as an argument.
bool takes_dt(const NamedFlight& s) { return mentions(launch_correction(s.flight).formula, "h"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

TEST_CASE("C++ compiles without a warning and does bit for bit what the library does in binary32") {
  if (!installed("g++")) return;
  const CodeFolder folder;
  std::string text = "#include <cstdio>\n", main = "int main() {\n";
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string space = "jump" + std::to_string(k);
    text += replaced(replaced(jump_code(flights()[k].flight, kG, Language::cpp), "#pragma once\n", ""),
                     "namespace jump", "namespace " + space);
    main += "  std::printf(\"%.9g %.9g %.9g %d\\n\", " + space + "::launch_velocity(1.7f), " + space +
            "::on_frame_launch_velocity(1.7f), " + space + "::highest_frame(" + launch_of(k, "f") + "), " +
            space + "::self_check());\n";
  }
  folder.write("jump.cpp", text + main + "}\n");
  folder.output(
      "g++ -std=c++17 -Wall -Wextra -Wpedantic -Wno-unused-variable -Werror -ffp-contract=off -o jump "
      "jump.cpp");
  compare_jumps(folder.output("./jump"), true);
}

TEST_CASE("Rust compiles, passes its own tests and does bit for bit what the library does in binary32") {
  if (!installed("rustc")) return;
  const CodeFolder folder;
  std::string text, main = "fn main() {\n";
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string space = "jump" + std::to_string(k);
    text += "mod " + space + " {\n" + jump_code(flights()[k].flight, kG, Language::rust) + "}\n";
    main += "    println!(\"{} {} {} 1\", " + space + "::launch_velocity(1.7, 9.81" +
            (takes_dt(flights()[k]) ? ", 0.02" : "") + "), " + space +
            "::on_frame_launch_velocity(1.7, 9.81, 0.02), " + space + "::highest_frame(" + launch_of(k) +
            ", 9.81, 0.02));\n";
  }
  folder.write("jump.rs", "#![allow(dead_code)]\n" + text + main + "}\n");
  folder.output("rustc --edition 2021 -A unused-variables -D warnings -o jump jump.rs");
  compare_jumps(folder.output("./jump"), true);
  folder.output("rustc --edition 2021 --test -o jump-test jump.rs && ./jump-test");
}

TEST_CASE("Python runs and agrees with the library") {
  if (!installed("python3")) return;
  const CodeFolder folder;
  std::string main;
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string space = "jump" + std::to_string(k);
    folder.write(space + ".py", jump_code(flights()[k].flight, kG, Language::python));
    main += "import " + space +
            " as j\nprint(repr(j.launch_velocity(1.7)), repr(j.on_frame_launch_velocity(1.7)), "
            "repr(j.highest_frame(" +
            launch_of(k) + ")), int(j.self_check()))\n";
  }
  folder.write("main.py", main);
  compare_jumps(folder.output("python3 main.py"), false);
  folder.output("python3 jump0.py");
}

TEST_CASE("JavaScript runs and agrees with the library") {
  if (!installed("node")) return;
  const CodeFolder folder;
  std::string main;
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string file = "jump" + std::to_string(k) + ".js";
    folder.write(file, "\"use strict\";\n" + jump_code(flights()[k].flight, kG, Language::javascript));
    main += "{ const j = require(\"./" + file +
            "\"); console.log(j.launchVelocity(1.7), j.onFrameLaunchVelocity(1.7), j.highestFrame(" +
            launch_of(k) + "), Number(j.selfCheck())); }\n";
  }
  folder.write("main.js", main);
  compare_jumps(folder.output("node main.js"), false);
}

TEST_CASE("C# compiles and agrees with the library") {
  if (!installed("mcs") || !installed("mono")) return;
  const CodeFolder folder;
  std::string text = "using System;\n", main = "static class Program { static void Main() {\n";
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string space = "Jump" + std::to_string(k);
    text += replaced(replaced(jump_code(flights()[k].flight, kG, Language::csharp), "using System;\n", ""),
                     "class Jump", "class " + space);
    main += "Console.WriteLine(\"{0:R} {1:R} {2:R} {3}\", " + space + ".LaunchVelocity(1.7f), " + space +
            ".OnFrameLaunchVelocity(1.7f), " + space + ".HighestFrame(" + launch_of(k, "f") + "), " + space +
            ".SelfCheck() ? 1 : 0);\n";
  }
  folder.write("jump.cs", text + main + "} }\n");
  folder.output("mcs -out:jump.exe jump.cs");
  compare_jumps(folder.output("mono jump.exe"), true);
}

TEST_CASE("GDScript runs and agrees with the library") {
  if (!installed("godot3-server")) return;
  const CodeFolder folder;
  std::string main = "extends SceneTree\n\nfunc _init():\n\tvar j\n";
  for (std::size_t k = 0; k < flights().size(); ++k) {
    const std::string file = "jump" + std::to_string(k) + ".gd";
    folder.write(file, jump_code(flights()[k].flight, kG, Language::gdscript));
    main += "\tj = load(\"res://" + file +
            "\")\n\tprint(\"jump \", j.launch_velocity(1.7), \" \", j.on_frame_launch_velocity(1.7), \" \", "
            "j.highest_frame(" +
            launch_of(k) + "), \" \", int(j.self_check()))\n";
  }
  folder.write("main.gd", main + "\tquit()\n");
  folder.write("project.godot", "config_version=4\n");
  std::istringstream said(folder.output("HOME=. timeout 60 godot3-server --no-window --script main.gd"));
  std::size_t k = 0;
  for (std::string line; std::getline(said, line);) {
    if (!line.starts_with("jump ")) continue;  // its banner
    REQUIRE(k < flights().size());
    CAPTURE(flights()[k].what);
    const Jump j = jump(flights()[k++].flight, Rational(17, 10), kG);
    std::istringstream in(line.substr(5));
    double launch = 0, on_frame = 0, top = 0, check = 0;
    REQUIRE(bool(in >> launch >> on_frame >> top >> check));
    // Godot prints six digits.
    CHECK(launch == doctest::Approx(j.corrected->launch.to_double()).epsilon(1e-5));
    CHECK(on_frame == doctest::Approx(j.on_frame->launch.to_double()).epsilon(1e-5));
    CHECK(top == doctest::Approx(static_cast<double>(j.binary32->top)).epsilon(1e-5));
    CHECK(check == 1);
  }
  CHECK(k == flights().size());
}

TEST_CASE("every language says what it corrects, by how much, and for which step") {
  for (const std::string& word : language_names()) {
    CAPTURE(word);
    const std::string text =
        jump_code(Flight(find_integrator("symplectic-euler"), kDt, 4), kG, *language_named(word));
    CHECK(text.find("symplectic-euler, 4 substeps a frame, under constant gravity") != std::string::npos);
    CHECK(text.find("too low by t times 0.024525 m/s at gravity = 9.81 m/s^2, dt = 0.02 s") !=
          std::string::npos);
    CHECK(text.find("1/8*gravity*dt") != std::string::npos);
    CHECK(text.find("impulse = mass * velocity") != std::string::npos);
    CHECK(text.find('@') == std::string::npos);
  }
}

TEST_CASE("where no launch correction exists there is no code, but the reason") {
  const Program damped = parse(
      "integrator test\n  param c : 1/T = 1/10\nstep\n  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v\n",
      "test");
  CHECK_THROWS_AS(jump_code(Flight(damped, kDt), kG, Language::python), Undefined);
}

}  // namespace
}  // namespace shortfall
