// SPDX-License-Identifier: GPL-3.0-or-later
// The order that trees give against the order that is seen, at 60 digits.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/series/order.hpp"
#include "tests/series/sixty_digits.hpp"

using namespace shortfall;
using testing::kDigits, testing::sixty_digits;

namespace {

struct Problem {
  const char* name;
  const char* forces;  ///< the class
  std::function<Real(const Real&, const Real&, const Real&)> force;
};

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all{
      {"the radius of a Kepler orbit", "position_only",
       [](const Real& x, const Real&, const Real&) -> Real { return 1 / (x * x * x) - 1 / (x * x); }},
      {"an anharmonic oscillator", "position_only",
       [](const Real& x, const Real&, const Real&) -> Real { return -x - x * x * x / 2 + x * x / 3; }},
      {"an anharmonic oscillator that is pushed", "velocity_independent",
       [](const Real& x, const Real&, const Real& t) -> Real {
         return -x - x * x * x / 2 + t * t / 3 + t * x / 2;
       }},
      {"a force that reads the velocity", "general", [](const Real& x, const Real& v, const Real& t) -> Real {
         return -x - x * x * x / 2 - v / 2 - v * v * x / 3 + t * v / 4 + t * t / 3;
       }}};
  return all;
}

std::pair<Real, Real> arrived(const Program& program, const Problem& problem, int steps) {
  Numbers<Real> numbers;
  numbers.round = sixty_digits;
  numbers.force = problem.force;
  const Tape tape = lower(program, parameter_values(program));
  Run<Numbers<Real>> run(tape, numbers, sixty_digits(Rational(1, 2 * steps)));
  run.begin(sixty_digits(Rational(5, 4)), sixty_digits(Rational(-1, 3)), sixty_digits(0));
  for (int n = 0; n < steps; ++n) run.step();
  return run.read_out();
}

double observed(const Program& program, const Problem& problem, int steps) {
  const auto a = arrived(program, problem, steps), b = arrived(program, problem, 2 * steps),
             c = arrived(program, problem, 4 * steps);
  const auto size = [](const auto& p, const auto& q) {
    return Real(abs(Real(p.first - q.first)) + abs(Real(p.second - q.second)));
  };
  return static_cast<double>(Real(log(Real(size(a, b) / size(b, c))) / log(sixty_digits(2))));
}

}  // namespace

TEST_CASE("the order by trees is the order observed, for four forces and the whole catalogue" *
          doctest::test_suite("thorough")) {
  const Precision precision(kDigits);
  for (const Program& program : catalogue()) {
    if (family(program) == "engines") continue;
    CAPTURE(program.name);
    const SeriesSource source(program, {});
    for (const Problem& problem : problems()) {
      CAPTURE(problem.name);
      const int order = order_of_class(source, force_class(problem.forces)).order;
      const double seen = observed(program, problem, order < 3 ? 60 : order < 5 ? 16 : 28);
      CAPTURE(seen);
      CHECK(std::abs(seen - order) < 0.25);
    }
  }
}
