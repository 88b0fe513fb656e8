// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall damping` and `shortfall spring` as a user meets them. Truth is the loop, in binary64.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

double decimal(const nlohmann::json& number) { return std::stod(number["decimal"].get<std::string>()); }

TEST_CASE("damping: what a loop keeps, how fast it falls in the end, how far it coasts") {
  const auto json = json_of("damping godot --param c=0.5 --dt 60Hz");
  CHECK(json["schema"] == "shortfall.damping/1");
  CHECK(json["integrator"] == "godot");
  CHECK(json["parameters"]["c"] == "1/2");
  CHECK(json["here"]["dt"] == "1/60");
  const double dt = 1.0 / 60;
  double falling = 0, coasting = 1, way = 0, after_second = 0;
  for (int n = 1; n <= 60 * 60; ++n) {
    falling = (1 - 0.5 * dt) * falling + dt * 9.81;
    coasting *= 1 - 0.5 * dt;
    way += dt * coasting;
    if (n == 60) after_second = coasting;
  }
  CHECK(decimal(json["here"]["terminal_speed"]) == doctest::Approx(falling).epsilon(1e-12));
  CHECK(decimal(json["here"]["kept_after_1s"]) == doctest::Approx(after_second).epsilon(1e-12));
  CHECK(decimal(json["here"]["coast"]) == doctest::Approx(way).epsilon(1e-12));
  CHECK(decimal(json["true_terminal_speed"]) == doctest::Approx(9.81 / 0.5));
  CHECK(json["rates"].size() == 4);
}

TEST_CASE("damping: every convention keeps the share that the frame keeps, and converts into every other") {
  const auto json = json_of("damping bullet --param c=0.5 --dt 60Hz");
  const double share = std::pow(0.5, 1.0 / 60), dt = 1.0 / 60;
  CHECK(decimal(json["here"]["share"]) == doctest::Approx(share).epsilon(1e-14));
  REQUIRE(json["conventions"].size() == 5);
  const auto c = [&](int i) { return decimal(json["conventions"][static_cast<std::size_t>(i)]["c"]); };
  CHECK(1 - c(0) * dt == doctest::Approx(share).epsilon(1e-14));
  CHECK(1 / (1 + c(1) * dt) == doctest::Approx(share).epsilon(1e-14));
  CHECK(std::pow(1 - c(2), dt) == doctest::Approx(share).epsilon(1e-14));
  CHECK(std::exp(-c(3) * dt) == doctest::Approx(share).epsilon(1e-14));
  for (const auto& one : json["conventions"]) CHECK(one["to"].size() == 5);
}

TEST_CASE("damping of all engines: a row each, those that do not damp with the reason") {
  const auto json = json_of("damping --all-engines --param c=0.1 --dt 60Hz");
  CHECK(json["integrators"].size() + json["refused"].size() == 17);
  CHECK(json["integrators"].size() >= 14);
  for (const auto& [name, why] : json["refused"].items()) CHECK(why.get<std::string>().size() > 20);
}

TEST_CASE("bad damping is refused in one sentence") {
  for (const auto& [line, code] : {std::pair{"damping godot --param c=-1", 2},
                                   {"damping godot --dt 0", 2},
                                   {"damping gdot", 2},
                                   {"damping symplectic-euler", 2},
                                   {"damping --lang cobol", 2},
                                   {"damping godot --param d=1", 2}}) {
    const std::string arguments = line;
    CAPTURE(arguments);
    const CommandRun o = run(arguments);
    CHECK(o.code == code);
    CHECK(o.out.empty());
    CHECK(o.error.starts_with("shortfall: "));
  }
  CHECK(contains(run("damping --lang pyton").error, "python"));
  CHECK(contains(run("damping --lang python").out, "def damped_move"));
  // One frame takes all of it, and more than all.
  CHECK(contains(run("damping ode --param c=1 --ascii").text(), "Stops dead"));
}

TEST_CASE("the true spring has the frequency that was asked for, also where frames are too few for it") {
  for (const std::string frequency : {"29.9", "30", "45", "60", "100"}) {
    CAPTURE(frequency);
    const auto json = json_of("spring symplectic-euler --dt 60Hz --frequency " + frequency + "Hz");
    CHECK(std::stod(json["true"]["frequency"]["decimal"].get<std::string>()) ==
          doctest::Approx(std::stod(frequency)));
    CHECK(json["effective"]["stable"] == false);
    const bool halves = frequency == "30" || frequency == "60";
    CHECK(json["kit"].is_null() == halves);
  }
  const CommandRun half = run("spring rk4 --frequency 30Hz --dt 60Hz");
  CHECK(half.code == 0);
  CHECK(contains(half.text(), "a whole number of half turns each frame"));
  CHECK(contains(run("spring symplectic-euler --frequency 45Hz --dt 60Hz").text(),
                 "faster than half the tick rate"));
  // Damped: exp(-c/2) a second, or what the slower exponential leaves.
  const auto damped = json_of("spring rk4 --k 100 --c 2 --dt 20Hz");
  CHECK(std::stod(damped["true"]["growth_per_second"]["decimal"].get<std::string>()) ==
        doctest::Approx(std::exp(-1)));
  CHECK(std::stod(damped["true"]["damping_ratio"]["decimal"].get<std::string>()) == doctest::Approx(0.1));
  const auto slow = json_of("spring rk4 --k 4 --c 5 --dt 20Hz");
  CHECK(std::stod(slow["true"]["growth_per_second"]["decimal"].get<std::string>()) ==
        doctest::Approx(std::exp(-1)));
  CHECK(slow["true"]["frequency"].is_null());
}

TEST_CASE("an undamped spring of 2 Hz at 60 Hz: frequency and damping ratio of the loop") {
  const auto json = json_of("spring symplectic-euler --frequency 2Hz --dt 60Hz");
  CHECK(json["schema"] == "shortfall.spring/1");
  CHECK(json["rounded"] == true);  // (4 pi)^2
  const double z = 2 * std::numbers::pi * 2 / 60;
  CHECK(decimal(json["effective"]["frequency"]) ==
        doctest::Approx(60 * std::acos(1 - z * z / 2) / (2 * std::numbers::pi)).epsilon(1e-12));
  CHECK(json["determinant"] == "1");
  // The implicit way damps it: |lambda|^2 = 1/(1 + z^2), angle atan z.
  const double decay = std::log1p(z * z) / 2, angle = std::atan(z);
  CHECK(decimal(json["native"]["effective"]["damping_ratio"]) ==
        doctest::Approx(decay / std::hypot(decay, angle)).epsilon(1e-10));
}

TEST_CASE(
    "a force held over N substeps: det = 1 + (1 - (N + 1)/(2 N)) w with w = (h omega)^2, so that it grows") {
  const auto json = json_of("spring symplectic-euler --k 40 --dt 60Hz --substeps 4 --held");
  CHECK(json["determinant"] == "3/8*k*h^2 + 1");
  CHECK(json["trace"] == "2 - 5/8*k*h^2");
  // Frames of the loop from (1, 0) and (0, 1) are the columns of the matrix.
  const double k = 40, h = 1.0 / 60;
  double column[2][2];
  for (int j = 0; j < 2; ++j) {
    double x = j == 0, v = j == 1;
    const double held = -k * x;
    for (int s = 0; s < 4; ++s) {
      v += h / 4 * held;
      x += h / 4 * v;
    }
    column[j][0] = x;
    column[j][1] = v;
  }
  const double determinant = column[0][0] * column[1][1] - column[1][0] * column[0][1];
  CHECK(decimal(json["effective"]["determinant"]) == doctest::Approx(determinant).epsilon(1e-14));
  CHECK(decimal(json["effective"]["trace"]) == doctest::Approx(column[0][0] + column[1][1]).epsilon(1e-14));
  CHECK(decimal(json["effective"]["growth_per_second"]) ==
        doctest::Approx(std::pow(determinant, 30)).epsilon(1e-12));
  CHECK(json["effective"]["stable"] == false);
  CHECK(run("spring symplectic-euler --k 40 --held").code == 2);
  CHECK(run("spring symplectic-euler --k 40 --frequency 2Hz").code == 2);
  CHECK(run("spring symplectic-euler --k 40 --damping-ratio 1").code == 2);
  CHECK(run("spring symplectic-euler").code == 2);
  CHECK(run("spring symplectic-euler --k 0").code == 2);
}

}  // namespace
}  // namespace shortfall
