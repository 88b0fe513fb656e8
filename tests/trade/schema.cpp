// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/trade/scene.hpp"

using namespace shortfall;

namespace {

/// The keys that a reader says it knows when it is given one that it does not.
std::set<std::string> known_keys(const std::string& scene) {
  try {
    scene_of(scene, "s.toml");
  } catch (const SyntaxError& e) {
    const std::string what = e.what();
    const std::size_t open = what.find("(there ");
    REQUIRE_MESSAGE(open != std::string::npos, what);
    const std::size_t begin = what.find(' ', open + 8) + 1;
    std::set<std::string> keys;
    std::string list = what.substr(begin, what.find(')', begin) - begin);
    for (std::size_t at = 0; at <= list.size();) {
      std::size_t end = list.find(", ", at);
      if (end == std::string::npos) end = list.size();
      keys.insert(list.substr(at, end - at));
      at = end + 2;
    }
    return keys;
  }
  FAIL("accepted");
  return {};
}

std::set<std::string> keys_of(const nlohmann::json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object["properties"].items()) keys.insert(key);
  return keys;
}

}  // namespace

TEST_CASE("the schema for editors knows the keys that the reader knows, kind by kind") {
  std::ifstream in(SHORTFALL_SOURCE_DIR "/share/scene.schema.json");
  const auto schema = nlohmann::json::parse(in);
  const std::string head = "until = 1\ndt = 0.1\n[[body]]\nposition = 1\n";
  const std::string force = "[[force]]\nkind = \"constant\"\nacceleration = 1\n";
  CHECK(keys_of(schema) == known_keys("bogus = 1\n"));
  const auto& all = schema["properties"];
  CHECK(keys_of(all["body"]["items"]) == known_keys("until = 1\ndt = 0.1\n[[body]]\nbogus = 1\n"));
  CHECK(keys_of(all["event"]["items"]) == known_keys(head + force + "[[event]]\nbogus = 1\n"));
  CHECK(keys_of(all["units"]) == known_keys("units = { bogus = 1 }\n"));
  int forces = 0, observables = 0;
  for (const auto& kind : all["force"]["items"]["oneOf"]) {
    const std::string name = kind["properties"]["kind"]["const"];
    CAPTURE(name);
    CHECK(keys_of(kind) == known_keys(head + "[[force]]\nkind = \"" + name + "\"\nbogus = 1\n"));
    ++forces;
  }
  for (const auto& kind : all["observable"]["items"]["oneOf"]) {
    const std::string name = kind["properties"]["kind"]["const"];
    CAPTURE(name);
    CHECK(keys_of(kind) == known_keys(head + force + "[[observable]]\nkind = \"" + name + "\"\nbogus = 1\n"));
    ++observables;
  }
  CHECK(forces == 14);
  CHECK(observables == 10);
  const std::string seen = "[[observable]]\nkind = \"position\"\ntolerance = 1\n";
  CHECK(keys_of(all["budget"]) == known_keys(head + force + seen + "[budget]\nbogus = 1\n"));
}
