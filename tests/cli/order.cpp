// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall order` as a user meets it: what it says, its JSON, its exit codes.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

const std::string kMethods = std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods/";

}  // namespace

TEST_CASE("order answers first, in one line") {
  Asked f("order");
  f.run("forest-ruth");
  CHECK(f.code == 0);
  CHECK(f.out.starts_with(
      "forest-ruth: order 4 for every force a(x, t); 1 when the force reads the velocity\n  proved"));
  // The letter of its coefficients is explained.
  CHECK(contains(f.out, "where θ ≈ 1.351207192 solves 6 θ³ − 12 θ² + 6 θ − 1 = 0"));
  f.run("dormand-prince --ascii");
  CHECK(f.out.starts_with("dormand-prince: order 5 for every force a(x, v, t)\n"));
  for (const char c : f.out) REQUIRE(static_cast<unsigned char>(c) < 128);
  CHECK(contains(f.out, "embedded      order 4"));
  CHECK(contains(f.out, "c = A 1       yes"));
}

TEST_CASE("the JSON of order has the orders, the proof, and the first errors exactly and as decimals") {
  Asked f("order");
  const auto json = f.json("rk4");
  CHECK(f.code == 0);
  CHECK(json["schema"] == "shortfall.order/1");
  CHECK(json["order"] == 4);
  for (const char* key :
       {"general", "velocity_independent", "autonomous", "position_only", "linear", "time_only", "separable"})
    CHECK(json["classes"][key] == 4);
  CHECK(json["proved"] == true);
  CHECK(json["digits"].is_null());
  CHECK(json["row_sums"] == true);
  CHECK(json["symplectic"]["holds"] == false);
  CHECK(json["conjugate_symplectic"]["trees_up_to"] == 5);
  CHECK(json["energy_change"]["order"] == 5);
  // Hairer, Norsett & Wanner (1993), II.3: nine trees of order five.
  CHECK(json["error_terms"].size() <= 9);
  for (const auto& term : json["error_terms"]) {
    CHECK(term["order"] == 5);
    CHECK(term["component"] == "y");
    CHECK(!term["tree"].get<std::string>().empty());
  }
  const auto& tall = json["error_terms"][0];
  CHECK(tall["differential"] == "f'f'f'f'f");
  CHECK(tall["coefficient"] == "-1/120");
  CHECK(tall["decimal"] == "-0.0083333333333333333333");
  CHECK(json["error_norm"]["squared"].is_string());
}

TEST_CASE("printed decimals are never called proved") {
  Asked f("order");
  const auto json = f.json("pefrl");
  CHECK(json["proved"] == false);
  CHECK(json["digits"].get<int>() >= 10);
  CHECK(json["symplectic"]["verdict"] != "proved");
  CHECK(json["symmetric"]["verdict"] != "proved");
  for (const auto& term : json["error_terms"]) CHECK(term["coefficient"]["digits"] == json["digits"]);
  f.run("pefrl");
  CHECK(!contains(f.out, "proved"));
  CHECK(contains(f.out, "digits after the point, as the coefficients are printed"));
}

TEST_CASE("one class of forces alone") {
  Asked f("order");
  auto json = f.json("mclachlan-atela-4 --force separable");
  CHECK(json["class"] == "separable");
  CHECK(json["order"] == 3);
  CHECK(json["classes"].size() == 1);
  CHECK(json["error_terms"][0]["order"] == 4);
  json = f.json("mclachlan-atela-4 --force 'a(x, t)'");
  CHECK(json["order"] == 4);
  f.run("mclachlan-atela-4 --force 'T(p) + V(q)'");
  CHECK(f.out.starts_with("mclachlan-atela-4: order 3 for T(p) + V(q)\n"));
  f.run("beeman --force separable");
  CHECK(f.code == 4);
  CHECK(contains(f.error, "kicks and drifts"));
  f.run("rk4 --force 'a(y)'");
  CHECK(f.code == 2);
  CHECK(contains(f.error, "no class of forces is called 'a(y)'"));
}

TEST_CASE("tableau files are read, and parameters taken") {
  Asked f("order");
  auto json = f.json("'" + kMethods + "fehlberg-45.json'");
  CHECK(json["order"] == 4);
  CHECK(json["embedded_order"] == 5);
  CHECK(f.json("newmark --param gamma=3/4")["order"] == 1);
  CHECK(f.json("newmark")["order"] == 2);
}

TEST_CASE("more trees than fit end with 4, say so, and do not take the memory") {
  Asked f("order");
  f.run("gauss6 --max-memory 20kB");
  CHECK(f.code == 4);
  CHECK(contains(f.out, "at least 6"));
  CHECK(contains(f.out, "order 7 has trees of"));
  CHECK(contains(f.out, "0.02 MB are allowed"));
  const auto json = f.json("gauss6 --max-memory 20kB");
  CHECK(json["too_many_trees"].contains("general"));
  CHECK(json["at_least"][0] == "general");
  f.run("gauss6 --max-memory 1");
  CHECK(f.code == 4);
  CHECK(f.out.empty());
  CHECK(contains(f.error, "no order of gauss6 is decided"));
  f.run("gauss6 --highest 50", limited(400, 60));
  CHECK(f.code == 0);
  for (const char* wrong :
       {"--highest 0", "--highest 101", "--highest x", "--max-memory much", "--max-memory -3"}) {
    f.run("rk4 " + std::string(wrong));
    CHECK_MESSAGE(f.code == 2, wrong);
  }
  f.run("no-such-integrator");
  CHECK(f.code == 2);
}

TEST_CASE("what the first order is not reached by is named") {
  Asked f("order");
  f.write("wrong.integrator",
          "integrator wrong\n  source nobody\n\nstep\n  v = v + h/2*a(x, v, t)\n  x = x + h*v\n");
  const auto json = f.json("wrong.integrator");
  CHECK(json["order"] == 0);
  CHECK(json["error_terms"][0]["differential"] == "a");
  CHECK(json["error_terms"][0]["coefficient"] == "-1/2");
  f.write("broken.integrator", "integrator broken\n\nstep\n  v = v + h*a(x, v\n");
  f.run("broken.integrator");
  CHECK(f.code == 3);
  CHECK(contains(f.error, "broken.integrator:4:"));
}

TEST_CASE(
    "a claim about orders that is wrong is refuted with what is true; one that is only not contradicted is "
    "not called proved") {
  Asked f("order");
  const std::string head =
      "integrator mine\n  source nobody\n\nstep\n  v = v + h*a(x, v, t)\n  x = x + h*v\n\nexpect\n";
  f.write("mine.integrator", head + "  order 2\n  symmetric\n  symplectic\n  order 1 if T(p) + V(q)\n");
  const CommandRun shown = f.Folder::run("show mine.integrator");
  CHECK(shown.code == 1);
  CHECK(contains(shown.out, "order 2: REFUTED, found order 1"));
  CHECK(contains(shown.out, "symmetric: REFUTED, found not symmetric: step and adjoint differ in h^2"));
  CHECK(contains(shown.out, "symplectic: holds\n"));
  CHECK(contains(shown.out, "order 1 if T(p) + V(q): holds"));
  // Kick-drift-kick, with a wrong first kick: symmetric from the second step on, which only trees tell.
  const auto json = f.json("stoermer-verlet-wrong-start");
  CHECK(json["symmetric"]["verdict"] == "not contradicted");
  CHECK(json["symmetric"]["trees_up_to"].get<int>() > 0);
}

}  // namespace shortfall
