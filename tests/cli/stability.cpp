// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall stability` as a user meets it: what it says, its JSON, its pictures, its exit codes.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "analysis/program/catalogue.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/cli/command.hpp"

namespace shortfall {

TEST_CASE("the limit: exact, 50 digits, an isolating interval, and what happens there") {
  Asked f("stability");
  f.run("rk4");
  CHECK(f.code == 0);
  CHECK(contains(f.out, "z = 2 √2 = 2.8284271247461900976033774484193961571393437507539"));
  CHECK(contains(f.out, "the only root of x² − 8 between 2.8 and 2.9"));
  CHECK(contains(f.out, "arccos(−⅓)"));
  f.run("symplectic-euler");
  CHECK(contains(f.out, "grows linearly, unless 2 x₀ − h v₀ = 0"));
  CHECK(contains(f.out, "xₙ = (−1)ⁿ ((1 + 2 n) x₀ − n h v₀)"));
  CHECK(contains(f.out, "reverses the velocity for 1 < d"));
  CHECK(contains(f.out, "this growth is right"));
}

TEST_CASE("a tiny limit keeps the zeros of its exponent") {
  Asked f("stability");
  f.write("stiff.integrator",
          "integrator stiff\n  source test\n  step\n    v = v + 100000000000000000000*h*a(x, v, t)\n"
          "    x = x + h*v\n");
  f.run("stiff.integrator");
  CHECK(contains(f.out, "z = 1/5000000000 = 2e-10\n"));
}

TEST_CASE("parameters: given ones are numbers, the others stay letters in the formulas") {
  Asked f("stability");
  f.run("newmark --param beta=0 --param gamma=1/2");
  CHECK(contains(f.out, "limit         z = 2\n"));
  CHECK(contains(f.out, "x grows linearly, unless v₀ = 0; v stays bounded"));
  f.run("newmark");
  CHECK(contains(f.out, "1 + β z²"));
  CHECK(contains(f.out, "defaults where --param does not say otherwise"));
  CHECK(contains(f.out, "stable        for every z > 0"));
}

TEST_CASE("plain ASCII is plain ASCII") {
  Asked f("stability");
  for (const char* name : {"rk4", "ruth3", "newmark", "implicit-euler", "adams-bashforth-2"}) {
    f.run(std::string(name) + " --ascii");
    CHECK(f.code == 0);
    for (const char c : f.out) REQUIRE(static_cast<unsigned char>(c) < 128);
  }
}

TEST_CASE("JSON: the fields that other programs rely on") {
  Asked f("stability");
  const auto verlet = f.json("velocity-verlet");
  CHECK(verlet["schema"] == "shortfall.stability/1");
  CHECK(verlet["integrator"] == "velocity-verlet");
  CHECK(verlet["trace"] == "2 - h^2*w^2");
  CHECK(verlet["determinant"] == "1");
  CHECK(verlet["limit"]["formula"] == "2");
  CHECK(verlet["at_limit"]["growth"] == "linear");
  CHECK(verlet["at_limit"]["position"] == "(-1)^n*(x0 - n*h*v0)");
  CHECK(verlet["at_limit"]["proved"] == true);
  CHECK(verlet["at_limit"]["on_unit_circle"][0]["largest_jordan_block"] == 2);
  CHECK(verlet["runaway"]["stable"] == "never");

  const auto rk4 = f.json("rk4");
  CHECK(rk4["limit"]["formula"] == "2*sqrt(2)");
  CHECK(rk4["limit"]["decimal"] == "2.8284271247461900976033774484193961571393437507539");
  CHECK(rk4["limit"]["digits"] == 50);
  CHECK(rk4["limit"]["polynomial"] == "x^2 - 8");
  CHECK(rk4["limit"]["interval"] == nlohmann::json{"2.8", "2.9"});
  CHECK(rk4["stability_function"]["a_stable"] == false);
  CHECK(rk4["stability_function"]["formula"] == "1 + z + 1/2*z^2 + 1/6*z^3 + 1/24*z^4");
  CHECK(rk4["drag"]["turns_round"].empty());

  const auto euler = f.json("implicit-euler");
  CHECK(euler["limit"].is_null());
  CHECK(euler["stable"] == "always");
  CHECK(euler["stability_function"]["l_stable"] == true);
  CHECK(euler["runaway"]["windows"][0]["from"]["formula"] == "2");

  CHECK(f.json("explicit-euler")["stable"] == "never");
  CHECK(f.json("symplectic-euler --substeps 4")["limit"]["formula"] == "8");
}

TEST_CASE(
    "JSON of every integrator parses, and every irrational has a formula or a polynomial, and 50 digits" *
    doctest::test_suite("thorough")) {
  Asked f("stability");
  for (const Program& p : catalogue()) {
    CAPTURE(p.name);
    // Engines are asked without their damping, which is a number a second.
    const bool damps = p.parameter("c") != nullptr;
    const Values given = damps ? Values{{"c", Rational(0)}} : Values{};
    const auto json = f.json(p.name + (damps ? " --param c=0" : ""));
    const auto limit = stability_limit(p, given);
    CHECK(json["limit"].is_null() == !limit);
    if (limit) {
      CHECK(json["limit"]["decimal"] == limit->significant(50));
      CHECK(json["limit"].contains("formula"));
      CHECK(json["limit"]["digits"] == 50);
    }
  }
}

TEST_CASE("bad input: one sentence each, and the exit code") {
  Asked f("stability");
  const auto said = [&](const std::string& arguments, int code, const std::string& part) {
    CAPTURE(arguments);
    f.run(arguments);
    CAPTURE(f.error);
    CHECK(f.code == code);
    CHECK(f.out.empty());
    CHECK(contains(f.error, part));
  };
  said("nonsense", 2, "unknown integrator 'nonsense'");
  said("newmark --param bta=0", 2, "did you mean 'beta'?");
  said("newmark --param beta=1/0", 2, "division by zero");
  for (const char* count : {"0", "-1", "10001", "two", "1.5", "2x", "99999999999999999999"})
    said(std::string("rk4 --substeps ") + count, 2,
         std::string("--substeps: '") + count + "' is not a whole number from 1 to 10000\n");
  said("rk4 --plot rk4.jpg", 2, ".svg, .png or .pdf");
  said("generalised-alpha --param rho=-1", 4, "the default alpha_m = (2*rho - 1)/(rho + 1) has no value");
  // A stage that no acceleration solves, under any oscillation.
  f.write("singular.integrator",
          "integrator singular\nstep\n  solve k : L/T^2 = k + a(x, v, t)\n  v = v + h*k\n  x = x + h*v\n");
  said("singular.integrator", 4, "singular");
  f.write("wrong.integrator", "integrator wrong\nstep\n  x = x + v\n");
  said("wrong.integrator", 3, "wrong.integrator:3:9");
  // A step that does not depend on h through h w and c h alone.
  f.write("own.integrator",
          "integrator own\n  param r : 1/T = 1\nstep\n  v = v + h*a(x, v, t) - h*r*v\n  x = x + h*v\n");
  said("own.integrator", 4, "give --param r=0");
  f.run("own.integrator --param r=0");
  CHECK(f.code == 0);
}

TEST_CASE("drag alone: a step that turns the velocity round from the beginning is said to") {
  CHECK(contains(run("stability ode --param c=3/2").text(), "reverses the velocity for 0 < d < 1"));
  CHECK(
      contains(run("stability matter-js --param c=1 --dt 1/50").text(), "reverses the velocity for 0 < d\n"));
  CHECK(contains(run("stability ode --param c=1/2").text(), "turns round"));
}

TEST_CASE("pictures by the ending of their name; without gnuplot a clear sentence") {
  Asked f("stability");
  f.run("rk4 --plot rk4.svg", "PATH=/nowhere");
  CHECK(f.code == 5);
  CHECK(contains(f.error, "gnuplot is not installed"));
  CHECK(contains(f.error, "apt-get install gnuplot-nox"));
  CHECK_FALSE(f.has("rk4.svg"));
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) {
    MESSAGE("gnuplot is not installed: pictures are not drawn here");
    return;
  }
  const std::pair<const char*, const char*> formats[] = {
      {"svg", "<?xml"}, {"png", "\x89PNG"}, {"pdf", "%PDF-"}};
  for (const auto& [format, beginning] : formats) {
    const std::string ending = format;
    CAPTURE(ending);
    f.run("rk4 --plot rk4." + ending);
    CHECK(f.code == 0);
    CHECK(contains(f.error, "wrote rk4." + ending));
    CHECK(f.text("rk4." + ending).starts_with(beginning));
  }
  f.run("rk4 --plot nowhere/rk4.svg");
  CHECK(f.code == 5);
}

}  // namespace shortfall
