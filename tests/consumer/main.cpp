// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <shortfall/notebooks-export/identify_text.hpp>
#include <shortfall/shortfall.hpp>
#include <string>

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
  // What is not in shortfall.hpp: a log as it is read, its maps, and the report; a scene.
  std::string text = "t,x\n";
  for (int n = 0; n < 40; ++n)  // x += v h, then v += a h, with h = 1/64, a = -8
    text += std::to_string(n / 64.0) + "," + std::to_string(n / 64.0 - n * (n - 1) / 1024.0) + "\n";
  const Log log = parse_log(text, "log");
  const bool told = as_text(log, identify(log)).find("maps reproduce 40 rows") != std::string::npos;
  const Scene scene = scene_of(
      "until = 1\ndt = 0.01\n[[body]]\nposition = 1\n[[force]]\nkind = \"spring\"\nstiffness = 2\n"
      "[[observable]]\nkind = \"position\"\ntolerance = 1\n",
      "scene.toml");
  return adds_up && exact && certain && told && scene.bodies.size() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
