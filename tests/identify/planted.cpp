// SPDX-License-Identifier: GPL-3.0-or-later
// Maps and parameters that a test plants are found again. Truth is what was planted.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <string>

#include "analysis/algebra/error.hpp"
#include "analysis/identify/experiments.hpp"
#include "analysis/identify/identification.hpp"
#include "analysis/program/catalogue.hpp"

namespace shortfall {
namespace {

/// A log of a map's flight, as a program would write it.
std::string log_of(const Candidate& c, const EngineFlight& flight, double dt, std::size_t rows, int decimals,
                   bool velocities) {
  std::string text = velocities ? "time,y,vy\n" : "time,y\n";
  std::vector<std::size_t> frames(rows);
  for (std::size_t i = 0; i < rows; ++i) frames[i] = i;
  char line[200];
  const bool narrow = flight.arithmetic == Arithmetic::binary32;
  fly(c, frames, dt, flight, [&](std::size_t row, const Log::Triple& x, const Log::Triple& v) {
    const auto put = [&](double value) {
      if (decimals >= 0)
        std::snprintf(line, sizeof line, ",%.*f", decimals, value);
      else
        std::snprintf(line, sizeof line, narrow ? ",%.9g" : ",%.17g", value);
      text += line;
    };
    std::snprintf(line, sizeof line, "%.12g", static_cast<double>(row) * dt);
    text += line;
    put(x[1]);
    if (velocities) put(v[1]);
    text += "\n";
    return true;
  });
  return text;
}

EngineFlight falling(double launch, double c, Arithmetic arithmetic) {
  EngineFlight f;
  f.v0 = {0, launch, 0};
  f.gravity = {0, -9.81, 0};
  f.c = c;
  f.arithmetic = arithmetic;
  return f;
}

bool lists(const Identification& found, const Candidate& c) {
  return std::ranges::any_of(found.matches, [&](const Match& m) { return m.candidate.str() == c.str(); });
}

TEST_CASE("a map that was planted is among those that are found, bit by bit, with its damping") {
  std::mt19937 random(1);
  std::vector<Candidate> engines;
  for (const Candidate& c : known_candidates())
    if (family(*c.program) == "engines" && c.own_damping && c.substep_count() <= 8) engines.push_back(c);
  int to_the_bit = 0;
  for (int i = 0; i < 8; ++i) {
    const Candidate& c = engines[random() % engines.size()];
    const double damping = 0.01 * (1 + static_cast<double>(random() % 30));
    const double launch = 2 + 0.001 * static_cast<double>(random() % 5000);
    const Arithmetic arithmetic = random() % 2 == 0 ? Arithmetic::binary32 : Arithmetic::binary64;
    EngineFlight flight = falling(launch, c.name() == "ode" ? damping / 10 : damping, arithmetic);
    CAPTURE(c.str());
    CAPTURE(damping);
    CAPTURE(launch);
    const Identification found = identify(parse_log(log_of(c, flight, 1.0 / 60, 70, -1, true), "log"));
    REQUIRE(found.kind == Identification::Kind::map);
    CHECK(lists(found, c));
    for (const Match& m : found.matches)
      if (m.candidate.str() == c.str()) {
        CHECK(m.flight.c == doctest::Approx(flight.c).epsilon(m.exact ? 1e-6 : 1e-3));
        to_the_bit += m.exact;
      }
  }
  // With seven substeps and a weak damping the last bit of the damping number is not always found.
  CHECK(to_the_bit >= 7);
}

TEST_CASE("a log that is rounded and has no velocities still lists the map that made it") {
  std::mt19937 random(2);
  for (const char* name : {"jolt", "rapier", "chipmunk"}) {
    const Program program = find_integrator(name);
    const Candidate c = candidate(program, std::nullopt);
    const double launch = 3 + 0.01 * static_cast<double>(random() % 300);
    const Identification found =
        identify(parse_log(log_of(c, falling(launch, 0.3, Arithmetic::binary32), 0.02, 80, 4, false), "log"));
    CAPTURE(name);
    CHECK(lists(found, c));
    CHECK_FALSE(found.identifiable);
    CHECK(found.advice.find("velocities") != std::string::npos);
  }
}

TEST_CASE("an undamped fall tells few maps apart, and damping tells more") {
  std::vector<Candidate> engines;  // of programs that the catalogue keeps
  for (const Program& program : catalogue())
    if (family(program) == "engines") engines.push_back(candidate(program, std::nullopt));
  const int undamped = group_count(groups(engines, experiments()[0]));
  const int damped = group_count(groups(engines, experiments()[1]));
  CHECK(undamped == 4);
  CHECK(damped >= 10);
}

TEST_CASE("sleep and a special first frame are breaks, and not another map") {
  const Program program = find_integrator("rapier");
  const Candidate c = candidate(program, std::nullopt);
  std::string text = log_of(c, falling(3, 0.5, Arithmetic::binary32), 0.02, 40, -1, true);
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  const std::string place = text.substr(text.find(',', last), text.rfind(',') - text.find(',', last));
  for (int i = 40; i < 50; ++i) text += std::to_string(0.02 * i) + place + ",0\n";
  const Identification found = identify(parse_log(text, "log"));
  REQUIRE(found.kind == Identification::Kind::map);
  REQUIRE(found.breaks.size() == 1);
  CHECK(found.breaks[0].kind == Break::Kind::sleep);
  CHECK(found.breaks[0].row == 40);
  CHECK(found.matches[0].candidate.str() == c.str());
}

TEST_CASE("what does not move says nothing, and what no map makes is answered so") {
  CHECK_THROWS_AS(identify(parse_log("y\n1\n1\n1\n1\n1\n", "log")), Undefined);
  std::string text = "time,y\n";
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i)
    text += std::to_string(0.02 * i) + "," + std::to_string(random() % 1000) + ".125\n";
  const Identification found = identify(parse_log(text, "log"));
  CHECK(found.kind == Identification::Kind::none);
  CHECK(found.matches.empty());
  CHECK(identify(parse_log("time,y\n0,1\n0.01,2\n0.03,3\n0.035,4\n0.05,1\n", "log")).kind ==
        Identification::Kind::unequal_steps);
}

}  // namespace
}  // namespace shortfall
