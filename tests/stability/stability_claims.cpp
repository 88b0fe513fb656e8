// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_claims.hpp"

#include <doctest/doctest.h>

#include "analysis/program/parse.hpp"

using namespace shortfall;

namespace {

const std::string kVerlet = "splitting\n  kick 1/2\n  drift 1\n  kick 1/2\n";
const std::string kForestRuthSplitting =
    "  root theta of 6*theta^3 - 12*theta^2 + 6*theta - 1 = 0\n"
    "splitting\n  drift theta/2\n  kick theta\n  drift (1 - theta)/2\n  kick 1 - 2*theta\n  drift (1 - "
    "theta)/2\n"
    "  kick theta\n  drift theta/2\n";
const std::string kRk4 = "tableau\n 0 |\n 1/2 | 1/2\n 1/2 | 0 1/2\n 1 | 0 0 1\n b | 1/6 1/3 1/3 1/6\n";
const std::string kTrapezoidal = "tableau\n 0 |\n 1 | 1/2 1/2\n b | 1/2 1/2\n";

ClaimVerdict verdict(const std::string& body, const std::string& claim) {
  const auto verdicts =
      stability_claims(parse("integrator test\n" + body + "expect\n  " + claim + "\n", "test.integrator"));
  REQUIRE(verdicts.size() == 1);
  return verdicts[0];
}

}  // namespace

TEST_CASE("trace and determinant are compared as functions of z and the parameters") {
  CHECK(verdict(kVerlet, "trace 2 - h^2*w^2").holds);
  CHECK(verdict(kVerlet, "trace 2 - z^2").holds);
  CHECK(verdict(kVerlet, "determinant 1").holds);
  CHECK_FALSE(verdict(kVerlet, "trace 2 - z^2/2").holds);
  CHECK(verdict(kVerlet, "trace 2 - z^2/2").found == "trace 2 - z^2");
  CHECK(verdict(kTrapezoidal, "trace 2*(1 - z^2/4)/(1 + z^2/4)").holds);
  const std::string weighted = "  param b = 1/4\nstep\n  v = v + h*a(x, v, t)\n  x = x + b*h*v\n";
  CHECK(verdict(weighted, "trace 2 - b*z^2").holds);
  CHECK_FALSE(verdict(weighted, "trace 2 - 1/4*z^2").holds);
}

TEST_CASE("limits are exact numbers, decimals that agree, infinity or 0") {
  CHECK(verdict(kVerlet, "limit 2").holds);
  CHECK_FALSE(verdict(kVerlet, "limit 2.1").holds);
  CHECK(verdict(kRk4, "limit 2*sqrt(2)").holds);
  CHECK(verdict(kRk4, "limit sqrt(8)").holds);
  CHECK_FALSE(verdict(kRk4, "limit -2*sqrt(2)").holds);
  CHECK_FALSE(verdict(kRk4, "limit 2*sqrt(3)").holds);
  CHECK(verdict(kRk4, "limit 2.828").holds);
  CHECK_FALSE(verdict(kRk4, "limit 2.85").holds);
  CHECK(verdict(kRk4, "limit 3").found == "limit 2*sqrt(2)");
  CHECK(verdict(kTrapezoidal, "limit infinity").holds);
  CHECK_FALSE(verdict(kVerlet, "limit infinity").holds);
  CHECK_FALSE(verdict(kTrapezoidal, "limit 2").holds);
  CHECK(verdict("step\n  x = x + h*v\n  v = v + h*a(x - h*v, v, t)\n", "limit 0").holds);
}

TEST_CASE("the limit of a method with a cube root agrees with the published digits") {
  // theory of splittings: Forest and Ruth (1990); the digits by bisection of |trace| = 2 with 40 digits.
  CHECK(verdict(kForestRuthSplitting, "limit 1.573401947434540").holds);
  CHECK_FALSE(verdict(kForestRuthSplitting, "limit 1.573401947434548").holds);
  CHECK(verdict(kForestRuthSplitting, "determinant 1").holds);
}

TEST_CASE("all claims come in the order of the file") {
  const auto verdicts = all_claims(parse(
      "integrator test\n" + kVerlet + "expect\n  limit 2\n  exact 0\n  determinant 1\n  shortfall 0\n", "t"));
  REQUIRE(verdicts.size() == 4);
  CHECK(verdicts[0].claim == "limit 2");
  CHECK(verdicts[1].claim == "exact 0");
  CHECK(verdicts[2].claim == "determinant 1");
  CHECK(verdicts[3].claim == "shortfall 0");
  for (const ClaimVerdict& v : verdicts) CHECK(v.holds);
}
