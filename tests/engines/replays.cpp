// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue's engines beside recordings of the real ones.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/step_map.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "tests/engines/replay.hpp"

namespace shortfall::engines {
namespace {

const std::vector<Recording>& samples() {
  static const std::vector<Recording> all = recordings(SHORTFALL_SOURCE_DIR "/tests/data/recordings");
  return all;
}

/// The recordings of one engine, those of its other solvers apart.
std::vector<Recording> samples_of(const std::string& integrator) {
  std::vector<Recording> result;
  for (const Recording& r : samples())
    if (integrator_of(r) == integrator) result.push_back(r);
  return result;
}

int exact(const std::vector<Recording>& recordings, const Program& program) {
  int count = 0;
  for (const Recording& r : recordings)
    if (program.impulse || !r.impulsive()) count += replay(r, program).exact;
  return count;
}

std::set<std::string> recorded() {
  std::set<std::string> names;
  for (const Recording& r : samples())
    if (replay(r).exact) names.insert(integrator_of(r));
  return names;
}

TEST_CASE("every recording that is known to agree to the last bit does") {
  std::map<std::string, int> count;
  int claimed = 0;
  for (const Recording& r : samples()) {
    const Outcome outcome = replay(r);
    CAPTURE(r.file);
    CAPTURE(outcome.reason);
    if (r.claimed) CHECK(outcome.exact);
    claimed += r.claimed;
    count[outcome.engine] += outcome.exact;
  }
  CHECK(claimed == 81);
  std::string found;
  for (const auto& [engine, exact] : count) found += engine + " " + std::to_string(exact) + ", ";
  CHECK(found ==
        "box2d-v2.4 6, box2d-v3 8, bullet 5, bullet-f64 4, cannon-es 6, chipmunk 5, jolt 9, matter-js 5, "
        "mujoco-euler 7, mujoco-implicitfast 5, ode 5, physx 11, planck 6, rapier3d 7, ");
}

TEST_CASE("what does not agree is a body asleep, a joint, or not the engine's own motion") {
  for (const Recording& r : samples()) {
    const Outcome outcome = replay(r);
    if (outcome.exact) continue;
    CAPTURE(r.file);
    CHECK_FALSE(r.claimed);
    CHECK((outcome.integrator.empty() || outcome.reason.find("to sleep") != std::string::npos));
  }
}

TEST_CASE("every engine's file says with how many recordings it was compared, at least those here") {
  for (const Program& program : catalogue()) {
    if (family(program) != "engines") continue;
    CAPTURE(program.name);
    int free = 0, exactly = 0;
    for (const Recording& r : samples_of(program.name)) {
      const Outcome outcome = replay(r);
      free += !outcome.integrator.empty();
      exactly += outcome.exact;
    }
    const std::size_t at = program.description.find("Compared with ");
    if (free == 0) {
      CHECK(at == std::string::npos);
      CHECK(program.description.find("Not compared with a recording") != std::string::npos);
      continue;
    }
    REQUIRE(at != std::string::npos);
    const std::string fact = program.description.substr(at);
    int all = 0, agree = 0;
    REQUIRE(std::sscanf(fact.c_str(), "Compared with %d", &all) == 1);
    if (fact.find("all agree to the last bit") == std::string::npos) {
      const std::size_t colon = fact.find(": ");
      REQUIRE(std::sscanf(fact.c_str() + colon, ": %d", &agree) == 1);
    } else {
      agree = all;
      CHECK(exactly == free);
    }
    CHECK(agree <= all);
    CHECK(all >= free);
    CHECK(agree >= exactly);
    CHECK(all - agree >= free - exactly);
  }
}

/// Engines whose steps are one and the same map; PhysX is Jolt with one collision step.
bool alike(const std::string& a, const std::string& b) {
  if (a == "physx" && b == "jolt") return true;
  static const std::vector<std::set<std::string>> kSame = {
      {"bullet", "cannon-es", "p2"}, {"box2d-2", "planck"}, {"mujoco-euler", "mujoco-implicitfast"}};
  return std::ranges::any_of(kSame, [&](const auto& s) { return s.contains(a) && s.contains(b); });
}

TEST_CASE("no engine's recordings are replayed by the map of another engine") {
  for (const std::string& name : recorded()) {
    const std::vector<Recording> own = samples_of(name);
    const int all = exact(own, find_integrator(name));
    for (const Program& other : catalogue()) {
      if (family(other) != "engines" || other.name == name || alike(name, other.name)) continue;
      CAPTURE(name);
      CAPTURE(other.name);
      CHECK(exact(own, other) < all);
    }
  }
}

bool same_map(const Program& a, const Program& b) {
  return step_map(lower(a), 0).step == step_map(lower(b), 0).step;
}

/// The program with two neighbouring statements exchanged, where that is a program and another map.
std::vector<Program> exchanged(const Program& program) {
  std::vector<Program> result;
  for (std::size_t i = 0; i + 1 < program.step.size(); ++i) {
    Program other = program;
    std::swap(other.step[i], other.step[i + 1]);
    try {
      other = parse(print(other), "exchanged");
      if (!same_map(program, other)) result.push_back(other);
    } catch (const SyntaxError&) {  // uses a name before it has a value
    }
  }
  return result;
}

TEST_CASE("two statements of an engine's step exchanged: its recordings do not agree any more") {
  int tried = 0;
  for (const std::string& name : recorded()) {
    const Program program = find_integrator(name);
    const std::vector<Recording> own = samples_of(name);
    const int all = exact(own, program);
    for (const Program& other : exchanged(program)) {
      CAPTURE(print(other));
      CHECK(exact(own, other) < all);
      ++tried;
    }
  }
  CHECK(tried == 13);
}

TEST_CASE("an order of operations that means the same in exact arithmetic is told apart") {
  struct Change {
    std::string name, from, to;
  };
  for (const Change& c : std::vector<Change>{
           {"physx", "(v + j + h*a(x, v, t))*max(0, 1 - c*h)",
            "(v + j)*max(0, 1 - c*h) + h*max(0, 1 - c*h)*a(x, v, t)"},
           {"rapier", "1/(1 + c*h)*v", "v/(1 + c*h)"},
           {"box2d", "d = d + h*v", "x = x + h*v"},
           {"box2d-2", "1/(1 + c*h)*(v + j + h*a(x, v, t))", "(v + j + h*a(x, v, t))/(1 + c*h)"},
           {"matter-js", "(h/ms)^2*(ms^2*a(x, v, t))", "h^2*a(x, v, t)"},
           {"matter-js", "(h*v + e)", "h*v"},
           {"ode", "h*(j/h + a(x, v, t))", "j + h*a(x, v, t)"},
           {"bullet", "(v + j)*pow(1 - c, h) + h*a(x, v, t)", "v*pow(1 - c, h) + h*(a(x, v, t) + j/h)"},
           {"physx-tgs-external-forces", "v + h*a(x, v, t) + h*b", "v + h*(a(x, v, t) + b)"}}) {
    const Program program = find_integrator(c.name);
    std::string text = print(program);
    const std::size_t at = text.find(c.from);
    CAPTURE(text);
    REQUIRE(at != std::string::npos);
    const std::vector<Recording> own = samples_of(c.name);
    CHECK(exact(own, parse(text.replace(at, c.from.size(), c.to), "changed")) < exact(own, program));
  }
}

}  // namespace
}  // namespace shortfall::engines
