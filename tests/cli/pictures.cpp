// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that commands draw, where gnuplot is here.
#include <doctest/doctest.h>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

TEST_CASE("clock --plot draws what is lost and how fast it goes; --kahan and other endings are refused") {
  const Folder folder;
  const CommandRun drawn = folder.run("clock --dt 1/60f --until 24h --plot clock.svg");
  if (drawn.code == 5) {  // gnuplot is not here
    CHECK(contains(drawn.error, "gnuplot"));
  } else {
    CHECK(drawn.code == 0);
    CHECK(contains(folder.text("clock.svg"), "speed off by (ppm)"));
  }
  CHECK(folder.run("clock --dt 1/60f --until 24h --plot clock.bmp").code == 2);
  CHECK(folder.run("clock --dt 1/60f --until 24h --kahan --plot kahan.svg").code == 2);
  CHECK_FALSE(folder.has("kahan.svg"));
}

TEST_CASE("portrait says what becomes of the energy, as text, table, JSON and picture") {
  const Folder folder;
  const CommandRun told = folder.run("portrait symplectic-euler --dt 1/2 --from 1,0 --from 1/2,-1");
  CHECK(told.code == 0);
  CHECK(contains(told.out, "in the potential V = x^2/2, mass 1, dt = 1/2 s, 200 frames in binary64"));
  CHECK(contains(told.out, "shortfall modified symplectic-euler --order 6 --hamiltonian"));
  CHECK(contains(folder.run("portrait rk4").out, "No other energy is conserved order by order: at h^4"));
  CHECK(contains(folder.run("portrait symplectic-euler --potential \"-x^4\"").out, "it runs away"));

  const CommandRun table = folder.run("portrait velocity-verlet --potential \"1 - cos(x)\" --steps 10 --csv");
  CHECK(std::ranges::count(table.out, '\n') == 12);
  CHECK(contains(table.out, "motion,frame,t,x,v,energy,modified_energy\n1,0,0,1,0,0.45969769413186023,"));
  const auto json = nlohmann::json::parse(folder.run("portrait velocity-verlet --steps 10 --json").out);
  CHECK(json["schema"] == "shortfall.portrait/1");
  CHECK(json["motions"][0]["x"].size() == 11);
  CHECK(json["motions"][0]["largest_change_of_modified_energy"] < 1e-3);

  const CommandRun drawn = folder.run("portrait velocity-verlet --potential \"1 - cos(x)\" --plot p.svg");
  if (drawn.code == 5) {  // gnuplot is not here
    CHECK(contains(drawn.error, "gnuplot"));
  } else {
    CHECK(drawn.code == 0);
    CHECK(contains(folder.text("p.svg"), "change of energy (J/kg)"));
  }
}

TEST_CASE("portrait refuses what is no potential and no start") {
  const Folder folder;
  const CommandRun letter = folder.run("portrait rk4 --potential \"k*x^2\"");
  CHECK(letter.code == 2);
  CHECK(contains(letter.error, "--potential:1:1: unknown name 'k'"));
  CHECK(contains(folder.run("portrait rk4 --potential \"abs(x)\"").error,
                 "there are sqrt, exp, pow, max, min, cos, sin, acos, atan, cosh, sinh, acosh, log"));
  CHECK(folder.run("portrait rk4 --potential \"x^\"").code == 2);
  CHECK(folder.run("portrait rk4 --potential \"1/x\" --from 0,1").code == 4);
  CHECK(folder.run("portrait rk4 --from 1").code == 2);
  CHECK(folder.run("portrait rk4 --from a,1").code == 2);
  CHECK(folder.run("portrait rk4 --steps 0").code == 2);
  CHECK(folder.run("portrait rk4 --json --csv").code == 2);
  CHECK(folder.run("portrait rk4 --plot p.bmp").code == 2);
}

}  // namespace
}  // namespace shortfall
