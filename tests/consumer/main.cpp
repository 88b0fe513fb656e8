// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <shortfall/shortfall.hpp>

int main() {
  using namespace shortfall;
  // Something from the headers, something that has to be linked, something that lies in the generated
  // catalogue.
  const Rational third(1, 3);
  const bool adds_up = third + third + third == Rational(1);
  const Program verlet = find_integrator("velocity-verlet");
  const bool exact = linear_kit(verlet, force_named("spring")).exists;
  // ... and something that needs every library below: FLINT, Arb, MPFR, GMP.
  NumericQuestion question;
  question.force = force_named("spring:k=1");
  question.x0 = 1;
  question.steps = Rational(10).pow(18);
  const bool certain = numeric_motion(verlet, question).position.decimal.has_value();
  return adds_up && exact && certain ? EXIT_SUCCESS : EXIT_FAILURE;
}
