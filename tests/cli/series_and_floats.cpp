// SPDX-License-Identifier: GPL-3.0-or-later
// order, modified, correct --force general, budget, cycle and extremes as a user meets them.
#include <doctest/doctest.h>

#include "tests/cli/command.hpp"

using namespace shortfall;

TEST_CASE("order --json: the fields that other programs rely on") {
  const Folder folder;
  const auto j = json_of(folder, "order forest-ruth");
  CHECK(j["schema"] == "shortfall.order/1");
  CHECK(j["order"] == 1);
  CHECK(j["classes"]["velocity_independent"] == 4);
  CHECK(j["classes"]["position_only"] == 4);
  CHECK(j["proved"] == true);
  CHECK(j["symplectic"]["verdict"] == "proved");
  CHECK(j["error_terms"].size() == 25);
  CHECK(json_of(folder, "order pefrl")["proved"] == false);
  CHECK(json_of(folder, "order pefrl")["digits"] == 16);
  CHECK(json_of(folder, "order symplectic-euler")["effective_order"] == 2);
  const auto dp = json_of(folder, "order dormand-prince");
  CHECK(dp["embedded_order"] == 4);
  CHECK(dp["error_norm"]["squared"] == "5573/34992000000");
}

TEST_CASE("a tableau of the user's own, and what cannot be done") {
  const Folder folder;
  folder.write("my.json", R"({"A": [[], ["2/3"]], "b": ["1/4", "3/4"], "order": 2})");
  CHECK(contains(folder.run("order my.json").out, "order 2 for every force a(x, v, t)"));
  CHECK(folder.run("order my.json --highest 1000").code == 2);
  CHECK(folder.run("modified my.json --order 60").code == 4);
  CHECK(contains(folder.run("modified my.json --order 60").error, "ask for order"));
  CHECK(contains(folder.run("modified my.json --max-memory 10kB --order 9").error, "are allowed"));
  CHECK(folder.run("modified my.json --max-memory lots").code == 2);
  CHECK(folder.run("modified my.json --modifying --hamiltonian").code == 2);
  CHECK(folder.run("order godot --param c=1/10").code == 4);
  CHECK(contains(folder.run("order rk5").error, "rk"));
}

TEST_CASE("modified --json: checksum and Hamiltonian") {
  const Folder folder;
  const auto j = json_of(folder, "modified midpoint --order 9");
  CHECK(j["checksum"] == "19063/26880");
  CHECK(json_of(folder, "modified midpoint --order 9 --modifying")["checksum"] == "5460293/241920");
  const auto h = json_of(folder, "modified symplectic-euler --hamiltonian --order 3")["hamiltonian"];
  CHECK(h["exists"] == true);
  CHECK(contains(h["one_dimensional"].get<std::string>(), "1/2 h v V'"));
  CHECK(json_of(folder, "modified explicit-euler --hamiltonian", 4)["hamiltonian"]["exists"] == false);
  CHECK(
      contains(folder.run("modified symplectic-euler --latex").out, "\\dot{v} = a - \\frac{1}{2} h a_{x} v"));
}

TEST_CASE("correct --force general: launch, certificate, exit codes") {
  const Folder folder;
  const auto j = json_of(folder, "correct symplectic-euler --force general");
  REQUIRE(j["classes"].size() == 2);
  CHECK(j["classes"][1]["effective_order"] == 2);
  CHECK(j["classes"][1]["launch"][0]["coefficient"] == "-1/2");
  CHECK(j["classes"][1]["is"].size() == 3);
  CHECK(j["classes"][0]["obstruction_proved"] == true);
  CHECK(folder.run("correct explicit-euler --force general").code == 4);
  CHECK(folder.run("correct velocity-verlet --force 'a(x, t)' --order 4").code == 0);
  CHECK(folder.run("correct velocity-verlet --force 'a(x, t)' --order 6").code == 4);
  CHECK(folder.run("correct velocity-verlet --order 4").code == 2);
  CHECK(folder.run("correct velocity-verlet --force general --order 1").code == 2);
  const CommandRun code = folder.run("correct symplectic-euler --force general --lang cpp");
  CHECK(code.code == 4);
  CHECK(contains(code.error, "is given as a formula"));
}

TEST_CASE("budget, cycle and extremes --json") {
  const Folder folder;
  auto j = json_of(folder, "budget symplectic-euler --height 1.7 --dt 0.02f --formats f32,f64");
  REQUIRE(j["budgets"].size() == 2);
  for (const auto& b : j["budgets"]) CHECK(b["quantities"][0]["closes"] == true);
  CHECK(j["budgets"][0]["quantities"][0]["rounding"] == "-63230183235194289/75557863725914323419136");
  j = json_of(folder, "cycle symplectic-euler --dt 1/8 --formats f16");
  CHECK(j["cycles"][0]["tail"] == 32);
  CHECK(j["cycles"][0]["period"] == 3466);
  CHECK(json_of(folder, "extremes --formats f32")["formats"][0]["cases"].size() > 20);
  for (const char* wrong :
       {"budget", "budget --height -1", "budget --height 1 --formats f31", "budget --steps 1.5",
        "budget --height 1 --steps 3", "budget --steps 10 --dt 0", "cycle --most 0",
        "cycle --formats f32+what", "budget --steps 10 --force spring", "budget --height 1 --plot x.gif"}) {
    CAPTURE(wrong);
    const CommandRun o = folder.run(wrong);
    CHECK(o.code == 2);
    CHECK(!o.error.empty());
    CHECK(o.out.empty());
  }
  CHECK(folder.run("budget --steps 1e18 --force spring:k=1").code == 4);
  CHECK(folder.run("cycle --most 10").code == 4);
  CHECK(folder.run("budget --height 1 -o /nowhere/x").code == 5);
}
