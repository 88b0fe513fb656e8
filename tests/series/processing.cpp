// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/processing.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"
#include "analysis/series/conjugation.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/twin.hpp"
#include "tests/series/sixty_digits.hpp"

using namespace shortfall;
using testing::kDigits, testing::sixty_digits;

namespace {

/// x'' = a(x, t) = -x - x^3/2 + t x/3 + 1/5: neither linear nor autonomous.
struct Oscillator {
  static Real a(const Real& x, const Real& t) {
    return -x - x * x * x / 2 + t * x / 3 + sixty_digits(Rational(1, 5));
  }
  static Real a_x(const Real& x, const Real& t) { return -1 - 3 * x * x / 2 + t / 3; }
  static Real a_t(const Real& x) { return x / 3; }
};

struct State {
  Real x, v, t;
};

/// The differentials that launches up to effective order 4 are made of.
Real differential(const std::string& name, const State& s) {
  const Real a = Oscillator::a(s.x, s.t), a_x = Oscillator::a_x(s.x, s.t);
  const std::map<std::string, Real> values{
      {"a", a}, {"v", s.v}, {"a_x v", a_x * s.v}, {"a_t", Oscillator::a_t(s.x)}, {"a_x a", a_x * a}};
  REQUIRE_MESSAGE(values.contains(name), name);
  return values.at(name);
}

State changed(const State& s, const std::vector<FieldTerm>& terms, const Real& h) {
  State result = s;
  for (const FieldTerm& t : terms) {
    Real value = sixty_digits(t.coefficient.constant()) * differential(t.differential, s);
    for (int k = 0; k < t.power; ++k) value *= h;
    (t.component == "x" ? result.x : result.v) += value;
  }
  return result;
}

/// Where x and v are at t = 1, launched, stepped and read out.
State arrived(const Program& program, const Processing& kit, int steps) {
  const Real h = sixty_digits(1) / steps;
  Numbers<Real> problem;
  problem.round = sixty_digits;
  problem.force = [&](const Real& x, const Real&, const Real& t) {
    const State here{x, sixty_digits(0), t};
    Real a = Oscillator::a(x, t);
    for (const FieldTerm& term : kit.force) {
      Real value = sixty_digits(term.coefficient.constant()) * differential(term.differential, here);
      for (int k = 0; k < term.power; ++k) value *= h;
      a += value;
    }
    return a;
  };
  const Tape tape = lower(program);
  Run<Numbers<Real>> run(tape, problem, h);
  const State s =
      changed({sixty_digits(Rational(3, 4)), sixty_digits(Rational(-1, 2)), sixty_digits(0)}, kit.launch, h);
  run.begin(s.x, s.v, s.t);
  for (int n = 0; n < steps; ++n) run.step();
  const auto [x, v] = run.read_out();
  return changed({x, v, sixty_digits(1)}, kit.read_out, h);
}

double observed_order(const std::string& integrator, const Processing& kit) {
  const Precision precision(kDigits);
  const Program program = find_integrator(integrator);
  const State a = arrived(program, kit, 20), b = arrived(program, kit, 40), c = arrived(program, kit, 80);
  const auto size = [](const State& p, const State& q) {
    return Real(abs(Real(p.x - q.x)) + abs(Real(p.v - q.v)));
  };
  return static_cast<double>(Real(log(Real(size(a, b) / size(b, c))) / log(sixty_digits(2))));
}

Processing kit_for(const std::string& integrator, const char* forces, int order, bool correct_force) {
  ProcessingQuestion q;
  q.forces = &force_class(forces);
  q.order = order;
  q.correct_force = correct_force;
  return processing(SeriesSource(find_integrator(integrator), {}), q);
}

std::string text(const std::vector<FieldTerm>& terms) {
  std::string result;
  for (const FieldTerm& t : terms)
    result += (result.empty() ? "" : "; ") + t.component + " " + t.coefficient.constant().str() + " h^" +
              std::to_string(t.power) + " " + t.differential;
  return result;
}

}  // namespace

TEST_CASE("half a kick at launch and read-out: symplectic Euler is then velocity Verlet, for every a(x, t)") {
  const Processing kit = kit_for("symplectic-euler", "a(x, t)", 2, false);
  CHECK(kit.plain_order == 1);
  CHECK(kit.effective_order == 2);
  CHECK(text(kit.launch) == "v -1/2 h^1 a");
  CHECK(text(kit.read_out) == "v 1/2 h^1 a");
  const std::vector<std::string> twins =
      processed_twins(find_integrator("symplectic-euler"), {}, Rational(-1, 2));
  CHECK(std::ranges::find(twins, "velocity-verlet") != twins.end());
  CHECK(processed_twins(find_integrator("symplectic-euler"), {}, Rational(1, 2)).empty());
  CHECK(processed_twins(find_integrator("symplectic-euler"), {}, Rational(-1, 3)).empty());
  CHECK(!processed_twins(find_integrator("symplectic-euler-drift-kick"), {}, Rational(1, 2)).empty());
}

TEST_CASE("kits that raise the order raise the order that is observed, and no more, at 60 digits") {
  struct Case {
    const char* integrator;
    int order;
    bool force;
  };
  for (const Case& c :
       {Case{"symplectic-euler", 2, false}, Case{"symplectic-euler-drift-kick", 2, false},
        Case{"symplectic-euler", 4, true}, Case{"velocity-verlet", 4, true}, Case{"position-verlet", 4, true},
        Case{"implicit-midpoint", 4, true}, Case{"newmark", 4, true}, Case{"leapfrog", 4, true},
        Case{"stoermer-verlet", 4, true}}) {
    CAPTURE(c.integrator);
    const Processing kit = kit_for(c.integrator, "a(x, t)", c.order, c.force);
    CHECK(kit.effective_order == c.order);
    CHECK(observed_order(c.integrator, kit) == doctest::Approx(c.order).epsilon(0.03));
    // The parts alone, or with a wrong sign, do not.
    Processing wrong = kit;
    for (FieldTerm& t : wrong.launch) t.coefficient = -t.coefficient;
    CHECK(observed_order(c.integrator, wrong) < c.order - 0.8);
    if (c.force) {
      Processing bare = kit;
      bare.launch.clear();
      bare.read_out.clear();
      CHECK(observed_order(c.integrator, bare) < 2.2);
      bare = kit;
      bare.force.clear();
      CHECK(observed_order(c.integrator, bare) < 2.2);
    }
  }
}

TEST_CASE("force corrections as Rowlands found them, for kick-drift-kick and drift-kick-drift") {
  const Processing kdk = kit_for("velocity-verlet", "a(x)", 4, true);
  CHECK(text(kdk.force) == "v 1/12 h^2 a_x a");
  CHECK(text(kdk.launch) == "v 1/12 h^2 a_x v; x -1/12 h^2 a");
  const Processing dkd = kit_for("position-verlet", "a(x)", 4, true);
  CHECK(text(dkd.force) == "v 1/12 h^2 a_x a");
  CHECK(text(dkd.launch) == "v -1/24 h^2 a_x v; x 1/24 h^2 a");
  // No force of the position alone gives order 6.
  const Processing six = kit_for("velocity-verlet", "a(x)", 6, true);
  CHECK(six.effective_order == 4);
  CHECK(six.obstructed_at == 5);
  CHECK(six.proved);
}

TEST_CASE("obstructions are named, and no launch changes their value") {
  CHECK(kit_for("explicit-euler", "a(x)", 2, true).obstruction.find("volume of phase space") !=
        std::string::npos);
  CHECK(kit_for("symplectic-euler", "general", 2, true).obstruction.find("velocity of another moment") !=
        std::string::npos);
  const Processing verlet = kit_for("velocity-verlet", "a(x)", 4, false);
  CHECK(verlet.obstructed_at == 3);
  CHECK(verlet.residual_value == Fraction(Rational(-1, 12)));

  // The certificate, applied to [c, F] for random c, gives 0.
  std::mt19937 generator(3);
  for (const char* forces : {"a(x)", "a(x, t)", "general"})
    for (const char* integrator : {"velocity-verlet", "rk4", "explicit-euler"}) {
      const Processing p = kit_for(integrator, forces, 5, false);
      if (p.obstruction.empty()) continue;
      const TreeTable table(force_class(forces).signature, p.obstructed_at);
      TreeSeries<Rational> c(table.size());
      for (TreeId t = table.begin(p.obstructed_at - 1); t < table.end(p.obstructed_at - 1); ++t)
        if (table.component(t) != 2) c[t] = std::uniform_int_distribution<int>(-9, 9)(generator);
      const TreeSeries<Rational> change = commutator(table, c, the_equation<Rational>(table));
      std::map<std::string, Rational> weights;
      for (const FieldTerm& t : p.residual) weights[t.component + t.tree] = t.coefficient.constant();
      Rational sum;
      for (TreeId t = 0; t < table.size(); ++t) {
        const auto found =
            weights.find(table.signature().components[table.component(t)] + tree_text(table, t));
        if (found != weights.end()) sum += found->second * change[t];
      }
      CHECK(sum.is_zero());
    }
}

TEST_CASE("a launch and its read-out undo each other, to every order of the table") {
  std::mt19937 generator(5);
  const TreeTable table(Signature::mechanical(true, true), 4);
  for (int repeat = 0; repeat < 5; ++repeat) {
    TreeSeries<Rational> map(table.size());
    for (TreeId t = 0; t < table.size(); ++t)
      if (table.component(t) != 2) map[t] = Rational(std::uniform_int_distribution<int>(-5, 5)(generator), 6);
    const TreeSeries<Rational> nothing(table.size());
    CHECK(composition(table, map, inverse(table, map)) == nothing);
    CHECK(composition(table, inverse(table, map), map) == nothing);
    // A map, another, and the first undone is the flow of the conjugated field.
    TreeSeries<Rational> c(table.size());
    for (TreeId t = table.begin(1); t < table.end(2); ++t)
      if (table.component(t) != 2) c[t] = Rational(std::uniform_int_distribution<int>(-5, 5)(generator), 4);
    const TreeSeries<Rational> launch = exponential(table, c);
    const TreeSeries<Rational> round =
        composition(table, composition(table, launch, map), inverse(table, launch));
    CHECK(logarithm(table, round) == conjugated(table, c, logarithm(table, map)));
  }
}
