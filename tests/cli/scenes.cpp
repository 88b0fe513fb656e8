// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>

#include "analysis/trade/point_store.hpp"

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
      json_of(folder, "trade s.toml --integrators symplectic-euler,velocity-verlet,rk4 --repeats 1");
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
  const CommandRun csv =
      folder.run("trade s.toml --integrators rk4 --formats f64 --repeats 0 --no-peers --csv -o t.csv");
  CHECK(csv.code == 0);
  CHECK(contains(folder.text("t.csv"), "\"rk4, f64\",rk4,f64,0,"));
  const CommandRun text =
      folder.run("trade s.toml --integrators rk4,symplectic-euler --repeats 0 --no-peers");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "* "));
}

TEST_CASE("trade: what cannot be stepped is listed with its reason; a file of the user's is stepped") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  folder.write("own.integrator", "integrator own\n\nstep\n  v = v + h*a(x, v, t)\n  x = x + h*v\n");
  const auto j = json_of(folder,
                         "trade s.toml --integrators symplectic-euler,own.integrator --formats f64 --repeats "
                         "0 --no-peers --no-launches");
  REQUIRE(j["series"].size() == 2);
  CHECK(j["series"][0]["points"][3]["errors"] == j["series"][1]["points"][3]["errors"]);
}

TEST_CASE("advise: what does not matter is left out, what is advised is good enough") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const auto j = json_of(folder, "advise s.toml");
  CHECK(j["schema"] == "shortfall.advise/1");
  REQUIRE(j["forces"].size() == 2);
  CHECK(j["forces"][0]["dropped"] == false);
  CHECK(j["forces"][1]["dropped"] == true);
  const double total = j["errors"][0]["total"].get<double>();
  CHECK(std::fabs(total) <= 1e-3);
  CHECK(j["best"]["evaluations"].get<int>() <= j["naive"]["evaluations"].get<int>());
  const CommandRun text = folder.run("advise s.toml --why");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "leave out breath"));
  CHECK(contains(text.out, "The parts of the error"));
}

TEST_CASE("advise --lang: the step that is advised, run as code, ends where the advice says") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const CommandRun o =
      folder.run("advise s.toml --lang python --integrators velocity-verlet,symplectic-euler");
  REQUIRE(o.code == 0);
  const std::string code = o.out.substr(o.out.find("# "));
  const auto j = json_of(folder, "advise s.toml --integrators velocity-verlet,symplectic-euler");
  const std::string frame = j["best"]["dt"];
  // The user's part: the force, the start, the loop.
  std::string program =
      "from fractions import Fraction\ndef acceleration(x, v, t):\n    return -x\nx, v, t, dt = 1.0, 0.0, "
      "0.0, float(Fraction('" +
      frame + "'))\nnow = 'start'\n";
  std::string body = code.substr(code.find("# Every step:"));
  const std::string once = code.substr(0, code.find("# Every step:"));
  const std::size_t shown = body.find("# For what is shown");
  const std::string read_out = shown == std::string::npos ? "" : body.substr(shown);
  body = body.substr(0, shown);
  std::string loop = "for n in range(" + std::to_string(j["best"]["steps"].get<int>()) + "):\n";
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) loop += "    " + line + "\n";
  folder.write("run.py", program + once + loop + "    t = t + dt\n" + read_out +
                             "import math\nprint(repr(x - math.cos(t)))\n");
  REQUIRE(std::system(("cd '" + folder.path("") + "' && python3 run.py > out.txt 2> err.txt").c_str()) == 0);
  CHECK(std::fabs(std::stod(folder.text("out.txt"))) < 1.1e-3);
  for (const char* language : {"csharp", "cpp", "gdscript", "rust", "javascript"})
    CHECK(contains(folder.run(std::string("advise s.toml --lang ") + language).out, "acceleration"));
  CHECK(folder.run("advise s.toml --lang cobol").code == 2);
  // Constants have the digits of the format that is advised: xi of PEFRL (Omelyan et al. 2002, eq. 20).
  const auto by_pefrl = [&](const std::string& format) {
    std::string scene = kOscillator;
    scene.replace(scene.find("[\"f32\", \"f64\"]"), 14, "[\"" + format + "\"]");
    folder.write("p.toml", scene);
    return folder.run("advise p.toml --lang cpp --integrators pefrl").out;
  };
  const std::string wide = by_pefrl("f64"), narrow = by_pefrl("f32");
  CHECK(contains(wide, "of f64 numbers"));
  CHECK(contains(wide, "0.1786178958448091"));
  CHECK_FALSE(contains(wide, "0f"));
  CHECK(contains(narrow, "of f32 numbers"));
  CHECK(contains(narrow, "0.1786178958448091f"));
}

TEST_CASE("advise: exit code 1 when nothing meets the tolerances, with what comes closest") {
  const Folder folder;
  std::string scene = kOscillator;
  scene.replace(scene.find("tolerance = 2e-3"), 16, "tolerance = 1e-9");
  scene.replace(scene.find("formats = [\"f32\", \"f64\"]"), 24, "formats = [\"f32\"]");
  folder.write("s.toml", scene);
  const CommandRun o = folder.run("advise s.toml");
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
  const CommandRun singular = folder.run("trade singular.toml");
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

TEST_CASE(
    "trade --store: killed again and again, it loses only what was in flight, and ends with the same "
    "points") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const std::string asked =
      "trade s.toml --integrators rk4,velocity-verlet --formats f64 --no-launches --no-peers --repeats 0 "
      "--dt "
      "0.005ms:50ms:log:16";
  std::int64_t kept = 0;
  for (const char* moment : {"0.3", "0.6", "0.9"}) {
    const CommandRun o = folder.run(asked + " --store s.sqlite", std::string("timeout -s KILL ") + moment);
    if (o.code == 0) break;
    CHECK(o.code == 137);
    if (!folder.has("s.sqlite")) continue;
    const std::int64_t now = PointStore(folder.path("s.sqlite")).size();
    CHECK(now >= kept);
    kept = now;
  }
  const auto resumed = json_of(folder, asked + " --store s.sqlite");
  CHECK(resumed == json_of(folder, asked));
  CHECK(PointStore(folder.path("s.sqlite")).size() == 32);
}

#ifdef SHORTFALL_MPIRUN
TEST_CASE("trade on 1, 2 and 4 processes of MPI: the same points give the same bits") {
  const Folder folder;
  folder.write("s.toml", kOscillator);
  const std::string asked =
      "trade s.toml --integrators rk4,velocity-verlet,implicit-midpoint --repeats 0 --no-peers --no-launches";
  const auto alone = json_of(folder, asked);
  for (const char* processes : {"1", "2", "4"}) {
    CAPTURE(processes);
    const CommandRun o =
        folder.run(asked + " --json --store " + processes + ".sqlite",
                   std::string("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 '") +
                       SHORTFALL_MPIRUN + "' --oversubscribe -n " + processes);
    REQUIRE_MESSAGE(o.code == 0, o.error);
    CHECK(nlohmann::json::parse(o.out) == alone);
    CHECK(PointStore(folder.path(std::string(processes) + ".sqlite")).size() == 66);
  }
  const CommandRun wrong = folder.run(
      "trade missing.toml", std::string("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 '") +
                                SHORTFALL_MPIRUN + "' --oversubscribe -n 2");
  CHECK(wrong.code != 0);
  // One process finds no scene where it is: the others do not wait for it.
  const CommandRun apart = folder.run(
      asked, std::string("OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 60 '") +
                 SHORTFALL_MPIRUN +
                 "' --oversubscribe -n 2 sh -c 'test \"$OMPI_COMM_WORLD_RANK\" = 0 || cd /; exec \"$@\"' sh");
  CHECK(apart.code != 0);
  CHECK(apart.code != 124);  // timeout's
  CHECK(contains(apart.error, "process 1 of mpirun"));
}
#endif
