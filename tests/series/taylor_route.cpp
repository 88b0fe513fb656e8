// SPDX-License-Identifier: GPL-3.0-or-later
// Trees against the Taylor series of the actual step, in exact arithmetic, for polynomial forces of the
// plane.
#include <doctest/doctest.h>

#include <random>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"
#include "analysis/series/step_series.hpp"
#include "tests/series/plane_force.hpp"

using namespace shortfall;
using testing::PlaneForce;

namespace {

struct RandomNumbers {
  std::mt19937 generator{11};
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator); }
  std::string fraction() { return std::to_string(whole(-5, 5)) + "/" + std::to_string(whole(1, 4)); }
};

/// a(x, v, t) with products of everything.
PlaneForce::Pair random_force(RandomNumbers& random) {
  const auto l = [](Letter letter) { return Polynomial::letter(letter); };
  const std::vector<Polynomial> pieces{
      l(0),        l(1),        l(2),        l(3),        l(4),        l(0) * l(1),       l(1) * l(2),
      l(2) * l(3), l(0) * l(4), l(3) * l(4), l(0) * l(0), l(2) * l(2), l(0) * l(1) * l(3)};
  PlaneForce::Pair a;
  for (Polynomial& p : a) {
    p = Polynomial(random.whole(-3, 3));
    for (int k = 0; k < 5; ++k)
      p += Polynomial(Rational(random.whole(-3, 3), random.whole(1, 2))) *
           pieces[static_cast<std::size_t>(random.whole(0, static_cast<int>(pieces.size()) - 1))];
  }
  return a;
}

/// The sum of h^|t| c(t)/sigma(t) F(t) over the trees of one component.
PlaneForce::Vector summed(const TreeTable& table, const TreeSeries<Rational>& series, int component,
                          PlaneForce& force) {
  PlaneForce::Vector total;
  for (TreeId t = 0; t < table.size(); ++t) {
    if (table.component(t) != component || series[t].is_zero()) continue;
    const Polynomial weight =
        Polynomial(series[t] / table.symmetry(t)) * Polynomial::letter(PlaneForce::kStep).pow(table.order(t));
    const PlaneForce::Pair f = force.differential(table, t);
    for (int i : {0, 1}) total.c[i] += weight * f[i];
  }
  return total;
}

/// Whether trees and Taylor series agree, all coefficients up to h^order.
bool agrees(const Program& program, RandomNumbers& random, int order, bool spoil = false) {
  const SeriesSource source(program, {});
  REQUIRE(source.rational());
  const TreeTable table(Signature::mechanical(true, true), order);
  OneStep<Rational> step = source.step<Rational>(table);
  REQUIRE(!step.carries);
  if (spoil) step.map[table.begin(3)] += Rational(1, 5);

  PlaneForce force(random_force(random), order);
  Run<PlaneForce> run(source.tape(), force, {Polynomial::letter(PlaneForce::kStep)});
  const PlaneForce::Vector x = PlaneForce::position(), v = PlaneForce::velocity();
  run.begin(x, v, {Polynomial::letter(PlaneForce::kTime)});
  run.step();
  const auto same = [&](const PlaneForce::Vector& found, const PlaneForce::Vector& expected) {
    const PlaneForce::Vector difference = force.truncated(found - expected);
    return difference.c[0].is_zero() && difference.c[1].is_zero();
  };
  return same(run.state(0), x + summed(table, step.map, 0, force)) &&
         same(run.state(1), v + summed(table, step.map, 1, force));
}

std::string random_tableau(RandomNumbers& random, bool implicit) {
  const int stages = random.whole(1, 3);
  std::string text = "integrator random-tableau\n  source nobody\n\ntableau\n";
  for (int i = 0; i < stages; ++i) {
    text += "  " + random.fraction() + " |";  // c need not be the sum of the row
    for (int j = 0; j < (implicit ? stages : i); ++j) text += " " + random.fraction();
    text += "\n";
  }
  text += "  b |";
  std::string last = "1";
  for (int i = 0; i + 1 < stages; ++i) {
    const std::string b = random.fraction();
    text += " " + b;
    last += "-(" + b + ")";
  }
  return text + " (" + last + ")\n";
}

std::string random_splitting(RandomNumbers& random) {
  std::string text = "integrator random-splitting\n  source nobody\n\nsplitting\n", kicks = "1", drifts = "1";
  for (int i = random.whole(0, 2); i >= 0; --i) {
    const std::string k = random.fraction(), d = random.fraction();
    text += "  kick " + k + "\n  drift " + d + "\n";
    kicks += " - (" + k + ")";
    drifts += " - (" + d + ")";
  }
  return text + "  kick " + kicks + "\n  drift " + drifts + "\n";
}

}  // namespace

TEST_CASE(
    "the tree series of a step is the Taylor series of the step, for the catalogue and random methods") {
  RandomNumbers random;
  int compared = 0;
  for (const Program& program : catalogue()) {
    if (program.approximate() || !program.roots.empty()) continue;
    CAPTURE(program.name);
    const SeriesSource source(program, {});
    if (!source.rational() || source.tape().states.size() > 2 || !source.tape().start.empty()) continue;
    CHECK(agrees(program, random, 5));
    ++compared;
  }
  CHECK(compared >= 20);
  for (int repeat = 0; repeat < 30; ++repeat) {
    const std::string text =
        repeat % 3 == 0 ? random_splitting(random) : random_tableau(random, repeat % 3 == 1);
    CAPTURE(text);
    try {
      CHECK(agrees(parse(text, "random.integrator"), random, repeat < 12 ? 5 : 4));
      ++compared;
    } catch (const Undefined&) {  // a stage that is singular
    }
  }
  CHECK(compared >= 45);
  CHECK_FALSE(agrees(find_integrator("rk4"), random, 4, true));
}
