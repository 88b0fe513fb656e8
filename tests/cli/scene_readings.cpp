// SPDX-License-Identifier: GPL-3.0-or-later
// What `shortfall trade` reads off a motion, against loops of a few lines.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/command.hpp"

using namespace shortfall;

namespace {

/// The errors of the only observable, one for each step, of a series.
std::vector<double> errors(const nlohmann::json& trade, const std::string& label) {
  std::vector<double> result;
  for (const auto& s : trade["series"])
    if (s["label"] == label)
      for (const auto& p : s["points"]) result.push_back(p["errors"][0].get<double>());
  return result;
}

const std::string kAsked =
    " --repeats 0 --no-peers --no-launches --integrators velocity-verlet,symplectic-euler --json --dt ";

/// A ball thrown up at 5 m/s.
std::string ball(const std::string& until, const std::string& reading) {
  return "until = \"" + until +
         "\"\ndt = \"60 Hz\"\n[[body]]\nposition = \"0 m\"\nvelocity = \"5 m/s\"\n[[force]]\nname = \"g\"\n"
         "kind = \"constant\"\nacceleration = \"-9.81 m/s^2\"\n[[observable]]\nkind = \"peak\"\n"
         "tolerance = \"1 cm\"\n" +
         reading;
}

/// The highest frame of a ball thrown up at 5 m/s.
double highest_frame(bool symplectic, double h) {
  double x = 0, v = 5, highest = 0;
  for (int n = 0; n < 200; ++n) {
    x += symplectic ? h * (v - 9.81 * h) : h * v - 9.81 * h * h / 2;
    v -= 9.81 * h;
    highest = std::max(highest, x);
  }
  return highest;
}

}  // namespace

TEST_CASE("the true peak is that between frames, whatever the run shows") {
  const Folder folder;
  for (const char* until : {"2 s", "20 s"}) {
    folder.write("s.toml", ball(until, "reading = \"frames\"\n"));
    const auto j = json_of(folder, "trade s.toml" + kAsked + "1/120:1/60:log:2");
    for (const auto& [label, symplectic] :
         {std::pair{"velocity-verlet, f64", false}, std::pair{"symplectic-euler, f64", true}}) {
      const std::vector<double> seen = errors(j, label);
      REQUIRE(seen.size() == 2);
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(seen[k] ==
              doctest::Approx(25 / (2 * 9.81) - highest_frame(symplectic, k == 0 ? 1.0 / 60 : 1.0 / 120))
                  .epsilon(1e-6));
    }
  }
}

TEST_CASE("no peak is read after the end of the scene") {
  const Folder folder;
  folder.write("s.toml", ball("0.5 s", ""));
  const auto j = json_of(folder, "trade s.toml" + kAsked + "0.15:0.35:log:2");
  for (const double error : errors(j, "velocity-verlet, f64")) CHECK(std::fabs(error) < 1e-14);
}

TEST_CASE("a path is that of the body that is named, otherwise of the farthest") {
  const Folder folder;
  const std::string asked = "trade s.toml" + kAsked + "1/20:1/10:log:2";
  const auto write = [&](const std::string& observable) {
    folder.write("s.toml",
                 "until = 2\ndt = 0.1\n[[body]]\nname = \"a\"\nposition = 0\nvelocity = 1\n[[body]]\nname = "
                 "\"b\"\nposition = 1\n[[force]]\nname = \"s\"\nkind = \"spring\"\nstiffness = 9\nbodies = "
                 "[\"b\"]\n[[observable]]\ntolerance = 1e-2\n" +
                     observable);
  };
  const auto largest = [&](const std::string& observable) {
    write(observable);
    const std::vector<double> e = errors(json_of(folder, asked), "symplectic-euler, f64");
    REQUIRE(e.size() == 2);
    return e[0];
  };
  CHECK(largest("kind = \"path\"\nbody = \"a\"\n") < 1e-13);
  CHECK(largest("kind = \"path\"\nbody = \"b\"\n") > 0.1);
  CHECK(largest("kind = \"path\"\n") == largest("kind = \"path\"\nbody = \"b\"\n"));
  write("kind = \"energy-drift\"\nbody = \"a\"\n");
  CHECK(folder.run(asked).code == 3);
}
