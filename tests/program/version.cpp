// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/program/version.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/program/find_refusal.hpp"

using namespace shortfall;

using testing::refusal;

TEST_CASE("the source of every engine names its version, and each is found with it") {
  for (const Program& p : catalogue()) {
    CAPTURE(p.name);
    CHECK(versions(p).empty() == (family(p) != "engines"));
    for (const SoftwareVersion& v : versions(p)) {
      std::string text;
      for (int number : v.numbers) {
        text += (text.empty() ? "" : ".") + std::to_string(number);
        CHECK(find_integrator(p.name + "@" + text).name == p.name);  // any beginning of it does
      }
      CHECK(v.text.starts_with(v.software + " " + text));
      CHECK(find_integrator(p.name + "@v" + text + ".7").name == p.name);
      for (const std::string& alias : p.aliases)
        if (alias.find('/') == std::string::npos) CHECK(find_integrator(alias + "@" + text).name == p.name);
    }
  }
}

TEST_CASE("another version of the same software is another file of the catalogue, or refused") {
  CHECK(find_integrator("box2d@2.4").name == "box2d-2");
  CHECK(find_integrator("box2d-2@3.1.1").name == "box2d");
  CHECK(find_integrator("godot@3.2").name == "godot");
  CHECK(find_integrator("godot@4.3").name == "godot");
  CHECK(find_integrator("mujoco-rk4@3.14").name == "mujoco-rk4");
  CHECK(refusal("rapier@0.17") ==
        "version 0.17 of Rapier is not known: the catalogue has Rapier 0.21 (rapier3d-compat) (rapier); "
        "other versions may step differently");
  CHECK(refusal("physx@4.1") ==
        "version 4.1 of PhysX is not known: the catalogue has PhysX 5.6.1 (physx-tgs-external-forces, "
        "physx); other versions may step differently");
  CHECK(refusal("box2d@2.3") ==
        "version 2.3 of Box2D is not known: the catalogue has Box2D 2.4.1 (box2d-2) and Box2D 3.1.1 "
        "(box2d); other versions may step differently");
  CHECK(refusal("godot@3") == "found godot");
  CHECK(refusal("godot@3.1").starts_with("version 3.1 of Godot is not known"));
}

TEST_CASE("what is no engine or no version is refused in a sentence") {
  CHECK(refusal("rk4@2") == "rk4 has no versions: it was read in no engine's source; write rk4 alone");
  for (const std::string text :
       {"", "x", "1.", ".1", "1..2", "-1", "1.-2", "1 2", "latest", "1@2", "v", "99999999999"}) {
    CAPTURE(text);
    CHECK(refusal("rapier@" + text) ==
          "'" + text +
              "' after the @ is no version; write rapier@ and numbers with points "
              "between them, such as 1.2");
  }
  CHECK(refusal("havok@1").starts_with("unknown integrator 'havok'"));
  CHECK(refusal("rapir@0.21").starts_with("unknown integrator 'rapir'; did you mean 'rapier'?"));
  CHECK(refusal("@1").starts_with("unknown integrator ''"));
}

TEST_CASE("versions agree when one is the beginning of the other: any two of one list, cut anywhere") {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<int> a(1 + random() % 4);
    for (int& n : a) n = static_cast<int>(random() % 30);
    std::string text;
    for (int n : a) text += (text.empty() ? "" : ".") + std::to_string(n);
    REQUIRE(version_numbers(text) == a);
    std::vector<int> b(a.begin(), a.begin() + 1 + static_cast<std::ptrdiff_t>(random() % a.size()));
    CHECK(agree(a, b));
    CHECK(agree(b, a));
    ++b.back();
    CHECK_FALSE(agree(a, b));
    CHECK_FALSE(agree(b, a));
  }
}
