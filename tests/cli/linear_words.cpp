// SPDX-License-Identifier: GPL-3.0-or-later
// Linear forces and engines as a user asks for them: code, long formulas, versions, held forces, and what is
// refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

std::size_t longest_line(const std::string& text) {
  std::istringstream in(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(in, line);) longest = std::max(longest, line.size());
  return longest;
}

TEST_CASE("correct --lang writes the kit of a linear force, and says why there is none") {
  const CommandRun cpp = run("correct symplectic-euler --force damped-spring --lang cpp");
  CHECK(cpp.code == 0);
  CHECK(contains(cpp.out, "struct ExactDampedSpring"));
  CHECK(contains(run("correct rapier --force drag --lang python").out, "class ExactDrag:"));
  CHECK(contains(run("correct velocity-verlet --force spring --lang gdscript").out, "class ExactSpring:"));
  CHECK(run("correct symplectic-euler --force spring --lang cpp --height 1").code == 2);
  const CommandRun unknown = run("correct symplectic-euler --force spring --lang klingon");
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.error, "we write csharp, cpp, gdscript, python, rust, javascript"));
}

TEST_CASE("long formulas are named in text and in LaTeX, complete with --full, and always complete in JSON") {
  const std::string question = "derive yoshida6 --force spring";
  const CommandRun named = run(question + " --ascii"), full = run(question + " --ascii --full");
  CHECK(longest_line(named.out) < 300);
  CHECK(longest_line(full.out) > 1000);
  const std::string trace = json_of(question)["trace"];
  CHECK(contains(full.out, "trace T = " + trace));
  CHECK_FALSE(contains(named.out, trace));
  CHECK(contains(named.out,
                 "(a polynomial of 8 terms, degree 14 in h, 7 in k; rounded here; --full prints it)"));
  CHECK(longest_line(run(question + " --latex").out) < 500);
  CHECK(longest_line(run(question + " --latex --full").out) > 1000);
  // Short ones stay as they are.
  CHECK(run("derive velocity-verlet --force spring").out ==
        run("derive velocity-verlet --force spring --full").out);
}

TEST_CASE("an engine may be asked for with its version, in every command") {
  CHECK(run("jump rapier@0.21 --height 1.7").out == run("jump rapier --height 1.7").out);
  CHECK(run("stability godot@4 --dt 60Hz").out == run("stability godot --dt 60Hz").out);
  CHECK(contains(run("derive box2d@2.4.1").out, "box2d-2"));
  for (const char* command : {"jump rapier@0.17 --height 1.7", "derive rapier@0.17", "show rapier@0.17",
                              "stability rapier@0.17", "correct rapier@0.17", "order rapier@0.17"}) {
    const CommandRun o = run(command);
    CHECK(o.code == 2);
    CHECK(contains(o.error, "version 0.17 of Rapier is not known: the catalogue has Rapier 0.21"));
  }
  CHECK(json_of("show rapier")["versions"][0] == "Rapier 0.21 (rapier3d-compat)");
  CHECK(contains(run("list engines").out, "[PhysX 5.6.1]"));
}

TEST_CASE("a launching force that is held over several frames") {
  const auto json = json_of("jump rapier --height 1.7 --launch force:5");
  CHECK(json["force"]["frames"] == 5);
  CHECK(json["on_frame"]["height"] == "17/10");
  CHECK(contains(run("jump rapier --height 1.7 --launch force:5").out, "held over frames 1 to 5"));
  CHECK(contains(run("jump --all-engines --height 1.7 --launch force:5").out, "held over frames 1 to 5"));
  CHECK(run("jump rapier --height 1.7 --launch force").out ==
        run("jump rapier --height 1.7 --launch force:1").out);
  for (const char* wrong :
       {"force:0", "force:", "force:x", "force:1001", "force:-1", "force:1.5", "forc", ""})
    CHECK(run("jump rapier --height 1.7 --launch '" + std::string(wrong) + "'").code == 2);
}

TEST_CASE("bad input and unstable physics are told in a sentence") {
  const std::pair<const char*, const char*> refused[] = {
      {"derive velocity-verlet --force spring:k=1,k=2", "k is given twice"},
      {"spring symplectic-euler --k -4 --dt 60Hz", "unstable physics"},
      {"spring symplectic-euler --k 0 --dt 60Hz", "without stiffness there is no spring"},
      {"jump --height 1.7 --dt 0", "it must be greater than 0"},
      {"derive implicit-euler --force spring:k=-2500 --dt 1/50 --steps 5",
       "there is no step of implicit-euler with dt = 1/50 s and this force: an implicit stage has no unique "
       "solution"},
      {"stability rapier --param c=-60 --dt 60Hz",
       "there is no step of rapier with these parameters and dt = 1/60 s"},
  };
  for (const auto& [line, sentence] : refused) {
    const std::string command = line;
    const CommandRun o = run(command);
    CAPTURE(command);
    CHECK((o.code == 2 || o.code == 4));
    CHECK(contains(o.error, sentence));
  }
  const CommandRun kit = run("correct symplectic-euler --force spring:k=-4 --dt 1/10");
  CHECK(kit.code == 0);
  CHECK(contains(kit.out, "k < 0: unstable physics, the true motion itself runs away"));
  CHECK(contains(run("derive explicit-euler --force spring:k=-1 --dt 1/10 --steps 10 --x0 1").out,
                 "k < 0: unstable physics"));
}

}  // namespace
}  // namespace shortfall
