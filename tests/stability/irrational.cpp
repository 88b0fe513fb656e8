// SPDX-License-Identifier: GPL-3.0-or-later
// Integrators with irrational coefficients, as the language writes them.
#include <doctest/doctest.h>

#include "analysis/program/parse.hpp"
#include "analysis/stability/stability.hpp"

using namespace shortfall;

namespace {

// Forest & Ruth (1990), Fourth-order symplectic integration, Physica D 43, (4.9): w = 1/(2 - 2^(1/3)).
const char* const kForestRuth = R"(integrator forest-ruth
  root c of c^3 = 2

step
  x = x + h/(2*(2 - c))*v
  v = v + h/(2 - c)*a(x, v, t + h/(2*(2 - c)))
  x = x + h*(1 - c)/(2*(2 - c))*v
  v = v - h*c/(2 - c)*a(x, v, t + h/2)
  x = x + h*(1 - c)/(2*(2 - c))*v
  v = v + h/(2 - c)*a(x, v, t + h - h/(2*(2 - c)))
  x = x + h/(2*(2 - c))*v
)";

// Hairer & Wanner (1996), IV.5, table 5.1: Gauss of order four.
const char* const kGauss4 = R"(integrator gauss-4
tableau
  1/2-sqrt(3)/6 | 1/4 1/4-sqrt(3)/6
  1/2+sqrt(3)/6 | 1/4+sqrt(3)/6 1/4
  b | 1/2 1/2
)";

// Alexander (1977): two stages of order two.
const char* const kSdirk2 = R"(integrator sdirk-2
tableau
  1-sqrt(2)/2 | 1-sqrt(2)/2
  1 | sqrt(2)/2 1-sqrt(2)/2
  b | sqrt(2)/2 1-sqrt(2)/2
)";

}  // namespace

TEST_CASE("Forest and Ruth's integrator, written in the language: its limit is the exact one") {
  const Program p = parse(kForestRuth, "forest-ruth.integrator");
  const Stability s = stability(p);
  REQUIRE(s.limit());
  CHECK(s.limit()->decimal(15) == "1.573401947434540");
  CHECK(s.limit()->degree() == 6);
  REQUIRE(s.at_limit);
  CHECK(s.at_limit->degree == 1);
  CHECK(s.undamped.determinant() == Fraction(1));
  CHECK(stability(p, {}, 3).limit()->decimal(12) == "4.720205842304");
}

TEST_CASE("Gauss of order four: R(z) is rational, Pade's (2, 2), A-stable, not L-stable") {
  const Stability s = stability(parse(kGauss4, "gauss-4.integrator"));
  CHECK(s.windows.always());
  CHECK(s.windows.windows[0].keeps);
  REQUIRE(s.function);
  CHECK(s.function->algebraic.empty());
  CHECK(s.function->numerator == Univariate<Algebraic>({1, Rational(1, 2), Rational(1, 12)}));
  CHECK(s.function->denominator == Univariate<Algebraic>({1, Rational(-1, 2), Rational(1, 12)}));
  CHECK(s.properties->a_stable);
  CHECK_FALSE(s.properties->l_stable);
}

TEST_CASE("SDIRK of order two: irrational coefficients in R(z), A- and L-stable") {
  const Stability s = stability(parse(kSdirk2, "sdirk-2.integrator"));
  CHECK(s.windows.always());
  REQUIRE(s.function);
  CHECK(s.function->algebraic.size() == 1);
  CHECK(s.properties->a_stable);
  CHECK(s.properties->l_stable);
}
