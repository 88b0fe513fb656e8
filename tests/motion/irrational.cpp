// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of integrators with irrational coefficients, exp, pow and max.
#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/motion/claims.hpp"
#include "analysis/motion/derivation.hpp"
#include "analysis/motion/linear_derivation.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"

using namespace shortfall;

namespace {

Program read(const std::string& text) { return parse("integrator test\n" + text, "test.integrator"); }

Program gauss4(const std::string& claim) {
  return read(
      "tableau\n  1/2-sqrt(3)/6 | 1/4 1/4-sqrt(3)/6\n  1/2+sqrt(3)/6 | 1/4+sqrt(3)/6 1/4\n  b | 1/2 1/2\n"
      "expect\n  " +
      claim + "\n");
}

bool claimed(const Program& p) {
  const auto verdicts = claims(p);
  return verdicts.size() == 1 && verdicts[0].holds;
}

}  // namespace

TEST_CASE(
    "Gauss's method of order 4 is exact for forces up to degree 2, by its nodes, and the error beyond is "
    "found") {
  // Position needs the moments of both sums: x has an error -h^4 t f3/180 for t^3, v an error for t^4 only.
  CHECK(claimed(gauss4("exact 2")));
  CHECK_FALSE(claimed(gauss4("exact 1")));
  CHECK_FALSE(claimed(gauss4("exact 3")));
  const Derivation d = derivation(gauss4("exact 2"), 4);
  CHECK(d.proved());
  CHECK(print(d.shortfall_position) == "-1/180*f3*h^4*t - 1/120*f4*h^4*t^2");
  // Gauss's quadrature with two nodes: the error of t^4 over a step is h^5/180.
  CHECK(print(d.shortfall_velocity) == "1/180*f4*h^4*t");
  CHECK(d.check.digits == 50);
}

TEST_CASE("a wrong node is found out: sqrt(3)/6 is not 0.2887") {
  CHECK_FALSE(claimed(
      read("tableau\n  0.2113 | 1/4 -0.0387\n  0.7887 | 0.5387 1/4\n  b | 1/2 1/2\nexpect\n  exact 2\n")));
}

TEST_CASE("a coefficient with a cube root: the triple jump is exact up to degree 3 in the velocity") {
  const Program p = read(
      "  root theta of 6*theta^3 - 12*theta^2 + 6*theta - 1 = 0\n"
      "splitting\n  drift theta/2\n  kick theta\n  drift (1 - theta)/2\n  kick 1 - 2*theta\n  drift (1 - "
      "theta)/2\n"
      "  kick theta\n  drift theta/2\n");
  const Derivation d = derivation(p, 3);
  CHECK(d.proved());
  CHECK(print(d.shortfall_velocity) == "0");
  CHECK(print(d.shortfall_position) == "1/48*theta^2*f3*h^4*t - 1/24*theta*f3*h^4*t + 1/120*f3*h^4*t");
  CHECK(print(derivation(p, 2).shortfall_position) == "0");
}

TEST_CASE("with a spring, Gauss 4 turns by Pade's (2,2) approximation") {
  // R(z) = (1 + z/2 + z^2/12)/(1 - z/2 + z^2/12): determinant 1, rational in h although sqrt(3) is in the
  // tableau.
  const LinearDerivation d = linear_derivation(gauss4("exact 2"), force_named("spring"));
  CHECK(d.proved());
  REQUIRE(d.determinant);
  CHECK(*d.determinant == Fraction(1));
  const Fraction y = Fraction::letter(kStepLetter, 2) * Fraction::letter(kStiffness);
  const Fraction even = Fraction(1) - y / Fraction(12), odd2 = y / Fraction(4);
  CHECK(*d.trace == Fraction(2) * (even * even - odd2) / (even * even + odd2));
}

TEST_CASE("max is decided by what the integrator assumes, and refused without") {
  const std::string step = "step\n  v = (v + h*a(x, v, t))*max(0, 1 - c*h)\n  x = x + h*v\n";
  const Derivation d = derivation(read("  param c : 1/T = 0.1\n  assume 1 - c*h > 0\n" + step), 0);
  CHECK(d.proved());
  CHECK(std::ranges::find(d.assumptions, "1 - c*h > 0") != d.assumptions.end());
  CHECK(print(d.velocity) == "v0*(1 - c*h)^n - (c*h - 1)/c*a + (c*h - 1)/c*a*(1 - c*h)^n");
  const Derivation plain =
      derivation(read("  param c : 1/T = 0.1\nstep\n  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v\n"), 0);
  CHECK(print(d.position) == print(plain.position));
  CHECK_THROWS_AS(derivation(read("  param c : 1/T = 0.1\n" + step), 0), Unable);
  CHECK_THROWS_AS(derivation(read("  param c : 1/T = 0.1\n  assume 2 - c*h > 0\n" + step), 0), Unable);
  // The contrary assumption stops the body.
  CHECK(print(derivation(read("  param c : 1/T = 0.1\n  assume c*h > 1\n" + step), 0).velocity) == "0");
}

TEST_CASE("exp and pow are letters in closed forms, checked with 80 digits") {
  const Derivation d =
      derivation(read("  param c = 0.1\nstep\n  v = v*pow(1 - c, h) + h*a(x, v, t)\n  x = x + h*v\n"), 1);
  CHECK(d.proved());
  CHECK(d.check.digits == 50);
  const Derivation e =
      derivation(read("  param c : 1/T = 0.1\nstep\n  v = v*exp(-c*h) + h*a(x, v, t)\n  x = x + h*v\n"), 0);
  CHECK(e.proved());
  CHECK_THROWS_AS(derivation(read("step\n  v = v*exp(-t/h)\n  x = x + h*v\n"), 0), Unable);
}

TEST_CASE("square roots that are related are one letter") {
  // sqrt(2)*sqrt(3) - sqrt(6) is 0, sqrt(8) is 2 sqrt(2), sqrt(1/2) is sqrt(2)/2.
  const Derivation d = derivation(read("step\n  x = x + h*v + (sqrt(2)*sqrt(3) - sqrt(6) + sqrt(8) - "
                                       "4*sqrt(1/2))*h*v\n  v = v + h*a(x, v, t)\n"),
                                  0);
  CHECK(print(d.position) == "x0 + v0*t + 1/2*a*t^2 - 1/2*a*h*t");
  CHECK(d.map.extras.size() == 2);
}

TEST_CASE("the phase of an oscillation gets a name that the integrator does not use") {
  const LinearDerivation d =
      linear_derivation(read("  param theta = 1/2\nstep\n  v = v + h*a(x, v, t)\n  x = x + 2*theta*h*v\n"),
                        force_named("spring"));
  REQUIRE(d.definitions.size() == 1);
  CHECK(d.definitions[0].name == "phi");
}

TEST_CASE("a closed form says which limits must not act, and that no impulse is given") {
  const Derivation d = derivation(
      read("  impulse j : L/T\nstep\n  v = v + j + h*a(x, v, t)\n  limit speed 500\n  when speed > 0.01 {\n"
           "    v = v*9/10\n  }\n  x = x + h*v\n"),
      0);
  const auto says = [&](const std::string& text) {
    return std::ranges::find(d.assumptions, text) != d.assumptions.end();
  };
  CHECK(says("'limit speed 500' never acts"));
  CHECK(says("'when speed > 0.01' always holds"));
  CHECK(says("no impulse is given"));
}

TEST_CASE("letters for functions are named as people write them") {
  const Derivation d =
      derivation(read("  param c = 0.1\nstep\n  v = v*pow(1 - c, h) + h*a(x, v, t)\n  x = x + h*v\n"), 0);
  CHECK(d.map.letters.back() == "pow(1 - c, h)");
}
