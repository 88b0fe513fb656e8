// SPDX-License-Identifier: GPL-3.0-or-later
// The order that is seen when the step is halved, with 60 digits, for an anharmonic force that depends on
// time: the coefficients of every file of the catalogue are checked by it without any of our algebra. The
// truth is the motion's Taylor series.
#include <doctest/doctest.h>

#include <map>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/tape.hpp"

using namespace shortfall;

namespace {

constexpr int kDigits = 60;

Real real_number(int numerator, int denominator = 1) {
  return real(Rational(numerator, denominator), kDigits);
}

/// x'' = -4 x - 3 x^3 + 2 t x + t^2, from x(0) = 1, v(0) = -1/2.
Real force(const Real& x, const Real&, const Real& t) {
  return real_number(-4) * x - real_number(3) * x * x * x + real_number(2) * t * x + t * t;
}

using Series = std::vector<Real>;

Real product(const Series& a, const Series& b, int n) {
  Real sum = real_number(0);
  for (int k = 0; k <= n; ++k) sum += a[k] * b[n - k];
  return sum;
}

/// Position and velocity at time 1, in steps of 1/32 with series of 40 terms: the radius of convergence is
/// far above 1/4, so what is left out is below 1e-36.
std::pair<Real, Real> truth() {
  constexpr int kTerms = 40, kSteps = 32;
  Real x = real_number(1), v = real_number(-1, 2);
  for (int step = 0; step < kSteps; ++step) {
    const Series t{real_number(step, kSteps), real_number(1)};
    Series s{x, v}, square, cube;
    for (int n = 0; n < kTerms; ++n) {
      square.push_back(product(s, s, n));
      cube.push_back(product(square, s, n));
      Real a = real_number(-4) * s[n] - real_number(3) * cube[n] + real_number(2) * t[0] * s[n];
      if (n > 0) a += real_number(2) * s[n - 1];
      if (n == 0) a += t[0] * t[0];
      if (n == 1) a += real_number(2) * t[0];
      if (n == 2) a += real_number(1);
      s.push_back(a / real_number((n + 1) * (n + 2)));
    }
    const Real h = real_number(1, kSteps);
    x = v = real_number(0);
    for (int n = kTerms; n >= 0; --n) {
      x = x * h + s[n];
      if (n > 0) v = v * h + real_number(n) * s[n];
    }
  }
  return {x, v};
}

Real error(const Program& program, int steps, const std::pair<Real, Real>& exact) {
  Numbers<Real> problem;
  problem.round = [](const Rational& r) { return real(r, kDigits); };
  problem.force = force;
  const Tape tape = lower(program, parameter_values(program));
  Run<Numbers<Real>> run(tape, problem, real_number(1, steps));
  run.begin(real_number(1), real_number(-1, 2), real_number(0));
  for (int n = 0; n < steps; ++n) run.step();
  const auto [x, v] = run.read_out();
  return abs(Real(x - exact.first)) + abs(Real(v - exact.second));
}

/// For forces a(x, t), from the publications that the files name.
const std::map<std::string, int> kOrder{{"explicit-euler", 1},
                                        {"half-gravity", 1},
                                        {"implicit-euler", 1},
                                        {"symplectic-euler", 1},
                                        {"symplectic-euler-drift-kick", 1},
                                        {"adams-bashforth-2", 2},
                                        {"bogacki-shampine", 3},
                                        {"dormand-prince", 5},
                                        {"gauss4", 4},
                                        {"gauss6", 6},
                                        {"heun", 2},
                                        {"implicit-midpoint", 2},
                                        {"kutta3", 3},
                                        {"midpoint", 2},
                                        {"radau-iia-3", 3},
                                        {"radau-iia-5", 5},
                                        {"ralston", 2},
                                        {"rk38", 4},
                                        {"rk4", 4},
                                        {"sdirk2", 2},
                                        {"sdirk4", 4},
                                        {"trapezoidal", 2},
                                        {"blanes-moan-rkn11", 6},
                                        {"blanes-moan-rkn14", 6},
                                        {"blanes-moan-rkn6", 4},
                                        {"blanes-moan-s10", 6},
                                        {"blanes-moan-s6", 4},
                                        {"forest-ruth", 4},
                                        {"mclachlan-atela-2", 2},
                                        {"mclachlan-atela-3", 3},
                                        {"mclachlan-atela-4", 4},
                                        {"mclachlan-s2", 2},
                                        {"mclachlan-s4", 4},
                                        {"mclachlan-s5", 4},
                                        {"mclachlan-sb3a", 4},
                                        {"pefrl", 4},
                                        {"ruth3", 3},
                                        {"suzuki4", 4},
                                        {"yoshida4", 4},
                                        {"yoshida6", 6},
                                        {"generalised-alpha", 2},
                                        {"newmark", 2},
                                        {"beeman", 2},
                                        {"leapfrog", 2},
                                        {"position-verlet", 2},
                                        {"stoermer-verlet", 2},
                                        {"stoermer-verlet-wrong-start", 1},
                                        {"velocity-verlet", 2}};

}  // namespace

TEST_CASE("every integrator shows the order that its publication claims, with 60 digits") {
  const Precision precision(kDigits);
  const auto exact = truth();
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;  // loops of programs: nobody published an order
    CAPTURE(program.name);
    REQUIRE(kOrder.contains(program.name));
    const int order = kOrder.at(program.name), steps = order < 3 ? 100 : 24;
    const Real coarse = error(program, steps, exact), fine = error(program, 2 * steps, exact);
    const double seen = static_cast<double>(Real(log(Real(coarse / fine)) / log(real_number(2))));
    CAPTURE(seen);
    CHECK(std::abs(seen - order) < 0.2);
  }
}
