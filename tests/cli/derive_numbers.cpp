// SPDX-License-Identifier: GPL-3.0-or-later
// `shortfall derive --steps` as a user meets it.
#include <doctest/doctest.h>

#include <string>

#include "analysis/algebra/rational.hpp"
#include "tests/cli/command.hpp"

namespace shortfall {
namespace {

CommandRun derive(const std::string& arguments) { return run("derive " + arguments); }

TEST_CASE("10^18 steps are answered with digits, the radius of the ball and the sign") {
  const CommandRun o = derive("velocity-verlet --force spring:k=1 --dt 1/10 --steps 1e18 --x0 1 --json");
  REQUIRE(o.code == 0);
  const auto json = nlohmann::json::parse(o.text());
  CHECK(json["schema"] == "shortfall.derive/1");
  CHECK(json["time"] == "100000000000000000");
  // cos(10^17), cos(10^18 acos(0.995)): computed with 100 digits elsewhere
  CHECK(json["exact"]["position"]["decimal"] == "-0.88555732829763068504963320701340541079529491091839");
  CHECK(json["position"]["decimal"] == "-0.69701056740423378161922900023254816738026187818481");
  CHECK(json["position"]["sign"] == -1);
  CHECK(json["position"]["digits"] == 50);
  CHECK(Rational::parse(json["position"]["radius"].get<std::string>()) < Rational::parse("1e-60"));
}

TEST_CASE("what is exact and short is a fraction") {
  const auto json = nlohmann::json::parse(
      derive("velocity-verlet --force spring:k=1 --dt 1/10 --until 0.5 --x0 1m --json").text());
  CHECK(json["steps"] == "5");
  CHECK(json["position"] == "17549650999/20000000000");
}

TEST_CASE("gravity is the constant force that is not given") {
  const CommandRun o = derive("symplectic-euler --steps 1e18 --v0 3");
  CHECK(contains(o.text(), "x'' = −981/100"));
  CHECK(contains(o.text(), "x(t) - x_n = 1962000000000000 m   exact"));
}

TEST_CASE("the runaway of an unstable step is still a number") {
  const CommandRun o = derive("explicit-euler --force spring:k=1 --dt 1/10 --steps 1e18 --x0 1");
  CHECK(contains(o.text(), "6.4567202788107927919484507218014951614760699851088e+2160686891321285"));
}

TEST_CASE("a question in numbers that lacks one is refused") {
  for (const auto& [line, word] : {std::pair{"--force spring --steps 5", "a number for k"},
                                   {"--force poly:1 --steps 5", "a number for f0"},
                                   {"--steps -1", "0 or more"},
                                   {"--steps 1/2", "whole number"},
                                   {"--steps 5 --until 1", "give one of them"},
                                   {"--until 0.03", "between two frames"},
                                   {"--steps 1e200", "from 0 to 10^100"},
                                   {"--force constant:a=1", "goes with --steps"},
                                   {"--force spring:q=1 --steps 1", "letters of the force"},
                                   {"--steps 5 --latex", "leave one of the two out"}}) {
    const std::string arguments = line;
    CAPTURE(arguments);
    const CommandRun o = derive(arguments);
    CHECK(o.code == 2);
    CHECK(contains(o.text(), word));
  }
  CHECK(derive("implicit-midpoint --force spring:k=-400 --dt 1/10 --steps 5").code == 4);
}

}  // namespace
}  // namespace shortfall
