// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the story that shortfall comes from (a blog post about a jump that falls short; g = 9.81, dt =
// 1/50), and what becomes of the jump in the engines. The figures were computed by other programs.
#include <doctest/doctest.h>

#include <string>

#include "analysis/correction/jump.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"

namespace shortfall {
namespace {

Jump story(const std::string& height, const std::string& integrator = "symplectic-euler", int substeps = 1) {
  return jump(find_integrator(integrator),
              JumpQuestion{.height = Rational::parse(height), .substeps = substeps});
}

std::string centimetres(const Surd& metres, int places) { return (metres * Surd(100)).decimal(places); }
std::string millimetres(const Surd& metres, int places) { return (metres * Surd(1000)).decimal(places); }

TEST_CASE("row 1: a 40 cm jump falls 2.762010199 cm short, at frame 14") {
  const Jump j = story("0.4");
  CHECK(j.best_frame.n == 14);
  CHECK(j.best_frame.height.decimal(12) == "0.372379898011");
  CHECK(centimetres(j.shortfall.total, 9) == "2.762010199");
}

TEST_CASE("row 2: a 170 cm jump falls 5.727052377 cm short, at frame 29") {
  const Jump j = story("1.7");
  CHECK(j.best_frame.n == 29);
  CHECK(j.best_frame.height.decimal(12) == "1.642729476232");
  CHECK(centimetres(j.shortfall.total, 9) == "5.727052377");
}

TEST_CASE("row 3: less than 1 mm of it is because the true peak falls between frames") {
  CHECK(millimetres(story("0.4").shortfall.sampling, 8) == "0.15210199");
  CHECK(millimetres(story("1.7").shortfall.sampling, 8) == "0.37252377");
  CHECK(story("0.4").shortfall.method == Surd(Rational(981, 100) / 2 * Rational(14, 2500)));
}

TEST_CASE(
    "row 4: corrected, a 1.7 m jump is 0.037252377 cm short and equals the sampled parabola at every frame") {
  const Jump j = story("1.7");
  REQUIRE(j.corrected);
  CHECK(centimetres(j.corrected->shortfall.total, 9) == "0.037252377");
  CHECK(j.corrected->shortfall.method.is_zero());
  CHECK(j.corrected->exact_at_every_frame);
  CHECK(print(j.correction.formula) == "1/2*g*h");
  CHECK(j.correction.value(j.g) == Rational(981, 10'000));
}

TEST_CASE("row 5: a jump leaves the ground if and only if it aims higher than g dt^2 / 2 = 1.962 mm") {
  CHECK(story("1").lift_off.height == Rational(1962, 1'000'000));
  const Jump at = story("0.001962");
  CHECK_FALSE(at.lifts_off);
  CHECK(at.best_frame.n == 0);
  CHECK(at.best_frame.height.is_zero());
  CHECK(at.shortfall.total == Surd(at.target));
  const Jump above = story("0.0019620001");
  CHECK(above.lifts_off);
  CHECK(above.best_frame.height.sign() > 0);
}

TEST_CASE(
    "row 6: after one frame s(1) = u dt + a dt^2, without the factor 1/2; for later frames with other "
    "factors") {
  const Flight flight(find_integrator("symplectic-euler"), Rational(1, 50));
  const Rational dt(1, 50);
  CHECK(flight.fall(1) == dt * dt);
  CHECK(flight.fall(2) != 2 * 2 * dt * dt);
  CHECK(flight.rise(2) == 2 * dt);
}

TEST_CASE("row 7: the error is not bounded: at the ideal time it is dt sqrt(g H / 2)") {
  for (const char* height : {"0.4", "1.7", "100", "1e6"}) {
    const Jump j = story(height);
    const Rational h = Rational::parse(height);
    CHECK(Surd(h) - *j.ideal_time_height == Surd(0, j.dt, j.g * h / 2));
  }
}

TEST_CASE("row 8: the distance to the target grows as sqrt(H): 44.3 cm at 100 m, and twice that at 400 m") {
  CHECK(centimetres(story("100").shortfall.total, 1) == "44.3");
  const auto distance = [](const char* height) {
    const Jump j = story(height);
    return Surd(j.target) - *j.ideal_time_height;
  };
  CHECK(distance("400") == Surd(2) * distance("100"));
}

TEST_CASE(
    "row 9: the relative error falls: 7.0 % at 40 cm, 0.44 % at 100 m; of the highest frame 6.9 %, 0.44 %") {
  const auto percent = [](const Surd& part, const Rational& whole, int places) {
    return (part * Surd(100 / whole)).decimal(places);
  };
  const Jump low = story("0.4"), high = story("100");
  CHECK(percent(Surd(low.target) - *low.ideal_time_height, low.target, 1) == "7.0");
  CHECK(percent(Surd(high.target) - *high.ideal_time_height, high.target, 2) == "0.44");
  CHECK(percent(low.shortfall.total, low.target, 1) == "6.9");
  CHECK(percent(high.shortfall.total, high.target, 2) == "0.44");
}

TEST_CASE("row 10: at the ideal time the height is lowest, -0.4905 mm, for H = g dt^2 / 8 = 0.4905 mm") {
  const Jump lowest = story("0.0004905");
  CHECK(*lowest.ideal_time_height == Surd(Rational(-4905, 10'000'000)));
  for (const char* beside : {"0.00049", "0.000491", "0.0001", "0.001"})
    CHECK(*story(beside).ideal_time_height > *lowest.ideal_time_height);
}

TEST_CASE("the top of the parabola through the frames is (u - g dt / 2)^2 / (2 g)") {
  const Jump j = story("1.7");
  const Surd speed = j.launch_velocity - Surd(j.g * j.dt / 2);
  CHECK(*j.parabola_top == speed * speed / Surd(2 * j.g));
}

TEST_CASE(
    "on a frame: u = H/(m dt) + g dt (m + 1)/2 with m(m - 1) <= 2 H/(g dt^2) <= m(m + 1) reaches H exactly") {
  for (const char* height : {"0.4", "1.7", "100", "1e-9", "1e9"}) {
    const Jump j = story(height);
    REQUIRE(j.on_frame);
    const Rational m = j.on_frame->top.n;
    CHECK(j.on_frame->launch == j.target / (m * j.dt) + j.g * j.dt * (m + 1) / 2);
    const Rational q = 2 * j.target / (j.g * j.dt * j.dt);
    CHECK(m * (m - 1) <= q);
    CHECK(q <= m * (m + 1));
    CHECK(j.on_frame->top.height == Surd(j.target));
  }
  CHECK(story("0.4").on_frame->top.n == 14);
  CHECK(story("1.7").on_frame->top.n == 29);
}

TEST_CASE("brought to H = 40 cm, frames 13 and 15 are not the highest: the tops are 0.4033 m and 0.4008 m") {
  const Flight flight(find_integrator("symplectic-euler"), Rational(1, 50));
  const Rational g(981, 100), height(2, 5);
  const auto top = [&](int m) {
    return flight.highest(Surd((height + g * flight.fall(m)) / flight.rise(m)), g).height.decimal(4);
  };
  CHECK(top(13) == "0.4033");
  CHECK(top(15) == "0.4008");
}

struct Engine {
  const char* engines;
  const char* integrator;
  int substeps;
  const char* low;       // 40 cm, cm short
  const char* low_with;  // the same with g dt / 2 more
  const char* high;      // 170 cm
  const char* high_with;
  const char* correction;
};

TEST_CASE("what becomes of the jump in the engines, with their own correction and with the famous one") {
  const Engine rows[] = {
      {"PhysX and most others", "symplectic-euler", 1, "2.762", "0.015", "5.727", "0.037", "1/2*g*h"},
      {"Rapier, Box2D 3, Jolt N = 4", "symplectic-euler", 4, "0.702", "-2.105", "1.460", "-4.352", "1/8*g*h"},
      {"Chipmunk", "symplectic-euler-drift-kick", 1, "-2.841", "-5.784", "-5.824", "-11.710", "-1/2*g*h"},
      {"MuJoCo RK4", "rk4", 1, "0.015", "-2.841", "0.037", "-5.824", "0"},
  };
  for (const Engine& row : rows) {
    CAPTURE(row.engines);
    const Flight flight(find_integrator(row.integrator), Rational(1, 50), row.substeps);
    for (const auto& [height, plain, with] :
         {std::tuple{"0.4", row.low, row.low_with}, {"1.7", row.high, row.high_with}}) {
      const Jump j = jump(flight, Rational::parse(height), Rational(981, 100));
      CHECK(centimetres(j.shortfall.total, 3) == plain);
      const Surd launch = j.launch_velocity + Surd(j.g * j.dt / 2);
      CHECK(centimetres(Surd(j.target) - flight.highest(launch, j.g).height, 3) == with);
      REQUIRE(j.corrected);
      CHECK(print(j.correction.formula) == row.correction);
      CHECK(j.corrected->exact_at_every_frame);
    }
  }
}

TEST_CASE("explicit Euler overshoots: -2.841 cm at 40 cm, as drift-kick does") {
  CHECK(centimetres(story("0.4", "explicit-euler").shortfall.total, 3) == "-2.841");
  CHECK(print(story("0.4", "explicit-euler").correction.formula) == "-1/2*g*h");
}

TEST_CASE(
    "a jump lifts off above g dt^2/2 ((N + 1)/(2 N))^2 with N substeps, always if it drifts first, above g "
    "dt^2/8 by RK4") {
  for (int n : {1, 2, 4, 7}) {
    const Rational ratio(n + 1, 2 * n);
    CHECK(story("1", "symplectic-euler", n).lift_off.height == Rational(1962, 1'000'000) * ratio * ratio);
    CHECK(print(story("1", "symplectic-euler", n).correction.formula) ==
          "1/" + std::to_string(2 * n) + "*g*h");
  }
  CHECK(story("1", "symplectic-euler-drift-kick").lift_off.height == Rational(0));
  CHECK(story("1", "explicit-euler").lift_off.height == Rational(0));
  CHECK(story("1", "rk4").lift_off.height == Rational(1962, 4'000'000));
}

}  // namespace
}  // namespace shortfall
