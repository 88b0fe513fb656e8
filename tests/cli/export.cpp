// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tests/cli/command.hpp"

using namespace shortfall;

TEST_CASE("export writes a folder with all that was asked for, the same bytes each time") {
  const Folder folder;
  const std::string all = "export symplectic-euler --force constant --notebook --html --latex --code all -o ";
  REQUIRE(folder.run(all + "one/").code == 0);
  REQUIRE(folder.run(all + "'a b \u00fc'").code == 0);
  for (const char* file :
       {"symplectic-euler.ipynb", "symplectic-euler.html", "symplectic-euler.tex", "code/symplectic-euler.cs",
        "code/symplectic-euler.hpp", "code/symplectic-euler.gd", "code/symplectic-euler.py",
        "code/symplectic-euler.rs", "code/symplectic-euler.js"}) {
    CAPTURE(file);
    CHECK(!folder.text(std::string("one/") + file).empty());
    CHECK(folder.text(std::string("one/") + file) == folder.text(std::string("a b \u00fc/") + file));
  }
}

TEST_CASE("exported C++ is a header, whatever is corrected") {
  const Folder folder;
  for (const std::string force : {"constant", "poly:1", "poly:2"}) {
    CAPTURE(force);
    REQUIRE(folder.run("export symplectic-euler --force " + force + " --code cpp -o " + force).code == 0);
    const std::string text = folder.text(force + "/code/symplectic-euler.hpp");
    const std::size_t guard = text.find("#pragma once");
    REQUIRE(guard != std::string::npos);
    CHECK(guard < text.find('{'));
    CHECK(text.find("#pragma once", guard + 1) == std::string::npos);
  }
}

TEST_CASE("export leaves a folder alone that holds something, unless it is told otherwise") {
  const Folder folder;
  fs::create_directory(folder.path("full"));
  folder.write("full/mine.txt", "mine");
  CommandRun o = folder.run("export symplectic-euler --html --latex -o full");
  CHECK(o.code == 5);
  CHECK(o.error.find("--overwrite") != std::string::npos);
  CHECK(!folder.has("full/symplectic-euler.html"));
  o = folder.run("export symplectic-euler --html --latex --overwrite -o full");
  CHECK(o.code == 0);
  CHECK(folder.has("full/symplectic-euler.html"));
  CHECK(folder.text("full/mine.txt") == "mine");
  folder.write("file", "a file");
  CHECK(folder.run("export symplectic-euler --html --latex -o file").code == 5);
  CHECK(folder.text("file") == "a file");
  CHECK(folder.run("export symplectic-euler --html --latex -o /proc/nothing/out").code == 5);
}

TEST_CASE("export says what is missing or unknown") {
  const Folder folder;
  CHECK(folder.run("export symplectic-euler -o out").code == 2);
  CHECK(folder.run("export symplectic-euler --html --latex").code == 2);
  const CommandRun o = folder.run("export symplectic-euler --code rusty -o out");
  CHECK(o.code == 2);
  CHECK(o.error.find("did you mean 'rust'") != std::string::npos);
  CHECK(!folder.has("out"));
  // Exact for its force: a page that says so, and no code.
  const CommandRun exact = folder.run("export velocity-verlet --force poly:1 --html --code all -o exact");
  CHECK(exact.code == 0);
}
