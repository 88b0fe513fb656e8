// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "tests/cli/command.hpp"

using namespace shortfall;

namespace {

const char* const kOscillator =
    "title = \"An oscillator\"\nuntil = 2\ndt = 0.1\nnaive = \"symplectic-euler\"\n[[body]]\nposition = "
    "1\n[[force]]\n"
    "name = \"spring\"\nkind = \"spring\"\nstiffness = 1\n[[force]]\nname = \"breath\"\nkind = \"constant\"\n"
    "acceleration = 1e-9\n[[observable]]\nkind = \"position\"\ntolerance = 2e-3\n[budget]\nformats = "
    "[\"f32\", \"f64\"]\n";

}  // namespace

TEST_CASE("trade: all points in JSON and CSV, orders, a front that only falls") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const auto j =
      json_of(folder, "trade s.toml --integrators symplectic-euler,velocity-verlet,rk4 --repeats 1 --json");
  CHECK(j["schema"] == "shortfall.trade/1");
  CHECK(j["series"].size() >= 6 + 7);  // and those of the other libraries
  for (const auto& s : j["series"]) {
    if (s["label"] != "rk4, f64" && s["label"] != "velocity-verlet, f64") continue;
    const double expected = s["label"] == "rk4, f64" ? 4 : 2;
    REQUIRE(!s["orders"][0].is_null());
    CHECK(std::fabs(s["orders"][0]["order"].get<double>() - expected) < 0.2);
  }
  double last = 1e300;
  for (const auto& p : j["observables"][0]["pareto"]) {
    const double e = std::fabs(
        j["series"][p["series"].get<std::size_t>()]["points"][p["point"].get<std::size_t>()]["errors"][0]
            .get<double>());
    CHECK(e < last);
    last = e;
  }
  const Outcome csv =
      folder.run("trade s.toml --integrators rk4 --formats f64 --repeats 0 --no-peers --csv -o t.csv");
  CHECK(csv.code == 0);
  CHECK(contains(folder.text("t.csv"), "\"rk4, f64\",rk4,f64,0,"));
  const Outcome text = folder.run("trade s.toml --integrators rk4,symplectic-euler --repeats 0 --no-peers");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "* "));
}

TEST_CASE("trade: what cannot be stepped is listed with its reason; a file of the user's is stepped") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  folder.write("own.integrator", "integrator own\n\nstep\n  v = v + h*a(x, v, t)\n  x = x + h*v\n");
  const auto j = json_of(folder,
                         "trade s.toml --integrators symplectic-euler,own.integrator --formats f64 --repeats "
                         "0 --no-peers --no-launches --json");
  REQUIRE(j["series"].size() == 2);
  CHECK(j["series"][0]["points"][3]["errors"] == j["series"][1]["points"][3]["errors"]);
}

TEST_CASE("advise: what does not matter is left out, what is advised is good enough") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const auto j = json_of(folder, "advise s.toml --json");
  CHECK(j["schema"] == "shortfall.advise/1");
  REQUIRE(j["forces"].size() == 2);
  CHECK(j["forces"][0]["dropped"] == false);
  CHECK(j["forces"][1]["dropped"] == true);
  const double total = j["errors"][0]["total"].get<double>();
  CHECK(std::fabs(total) <= 1e-3);
  CHECK(j["best"]["evaluations"].get<int>() <= j["naive"]["evaluations"].get<int>());
  const Outcome text = folder.run("advise s.toml --why");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "leave out breath"));
  CHECK(contains(text.out, "The parts of the error"));
}

TEST_CASE("advise: exit code 1 when nothing meets the tolerances, with what comes closest") {
  const Folder folder;
  std::string scene = kOscillator;
  scene.replace(scene.find("tolerance = 2e-3"), 16, "tolerance = 1e-9");
  scene.replace(scene.find("formats = [\"f32\", \"f64\"]"), 24, "formats = [\"f32\"]");
  folder.write("s.toml", scene);
  const Outcome o = folder.run("advise s.toml");
  CHECK(o.code == 1);
  CHECK(contains(o.out, "Closest"));
}

TEST_CASE("scenes that cannot be: exit codes and one sentence, at once") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  std::string bad = kOscillator;
  folder.write("key.toml", bad.replace(bad.find("stiffness"), 9, "stiffnes"));
  folder.write("singular.toml",
               "until = 10\ndt = 0.1\ndimension = 2\n[[body]]\nposition = [0, 0]\nvelocity = [1, "
               "0]\n[[force]]\nkind = \"kepler\"\n"
               "mu = 1\n[[observable]]\nkind = \"position\"\ntolerance = 1\n");
  CHECK(folder.run("trade key.toml").code == 3);
  CHECK(contains(folder.run("advise key.toml").error, "key.toml:10:1"));
  CHECK(folder.run("trade missing.toml").code == 5);
  const Outcome singular = folder.run("trade singular.toml");
  CHECK(singular.code == 4);
  CHECK(contains(singular.error, "singular"));
  CHECK(folder.run("trade s.toml --integrators rk9").code == 2);
  CHECK(folder.run("trade s.toml --formats f31").code == 2);
  CHECK(folder.run("trade s.toml --formats f16").code == 4);
  CHECK(folder.run("trade s.toml --plot x.gif").code == 2);
  CHECK(folder.run("trade s.toml --json --csv").code == 2);
  CHECK(folder.run("trade s.toml --until 5kg").code == 2);
  CHECK(folder.run("trade s.toml --dt 1e-12").code == 2);
  CHECK(folder.run("advise s.toml --margin 0.5").code == 2);
  CHECK(folder.run("trade s.toml --repeats 0 --no-peers -o /nowhere/x").code == 5);
}
