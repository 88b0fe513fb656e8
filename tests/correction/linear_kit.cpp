// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/linear_kit.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/undamped_catalogue.hpp"

#include <doctest/doctest.h>

#include <random>

#include "tests/correction/linear_motions.hpp"

using namespace shortfall;
using namespace shortfall::linear;

namespace {

const std::vector<Case> kCases = {
    {"spring", 3, 0, {}},
    {"damped-spring", 5, Rational(1, 3), {}},
    {"constant+damped-spring", Rational(7, 2), Rational(2, 5), {Rational(-981, 100)}},
    {"drag", 0, Rational(3, 7), {Rational(-981, 100)}},
    {"constant+spring", 2, 0, {Rational(5, 3)}},
    {"poly:2+spring", Rational(9, 4), 0, {1, Rational(-1, 3), Rational(2, 7)}},
    {"poly:3+damped-spring", 3, Rational(1, 2), {1, Rational(-1, 3), Rational(2, 7), Rational(1, 11)}},
    {"poly:1+drag", 0, Rational(3, 7), {Rational(-981, 100), Rational(2, 3)}},
};

}  // namespace

TEST_CASE("kits hold at random stiffness, damping, step and force") {
  const Precision precision(kDigits);
  std::mt19937 random(1642);
  const auto draw = [&](int low, int high, int below) {
    return Rational(low + static_cast<int>(random() % (high - low + 1)),
                    1 + static_cast<int>(random() % below));
  };
  for (const char* integrator :
       {"symplectic-euler", "velocity-verlet", "heun", "rk4", "adams-bashforth-2", "beeman",
        "generalised-alpha", "implicit-midpoint", "leapfrog", "radau-iia-3"})
    for (const char* force : {"poly:1+spring", "constant+damped-spring", "drag"}) {
      CAPTURE(integrator);
      CAPTURE(force);
      const Force named = force_named(force);
      const Program p = find_integrator(integrator);
      const LinearKit kit = linear_kit(p, named, parameter_values(p));
      REQUIRE(kit.exists);
      for (int trial = 0; trial < 3; ++trial) {
        Case test{force,
                  named.spring ? draw(1, 30, 5) : Rational(0),
                  named.damper ? draw(1, 6, 7) : Rational(0),
                  {}};
        for (int d = 0; d <= named.degree; ++d) test.push.push_back(draw(-30, 30, 7));
        if (named.damper && test.k * 4 == test.c * test.c) continue;
        Motions m(p, test, Rational(1, 20 + static_cast<int>(random() % 40)));
        check_every_frame(m, kit, 50);
      }
    }
}

TEST_CASE("critical and strong damping and a spring that repels: the same kit, the flow of that case" *
          doctest::test_suite("thorough")) {
  const Precision precision(kDigits);
  const std::vector<Case> cases = {
      {"damped-spring", 4, 4, {}},
      {"damped-spring", 2, 3, {}},
      {"damped-spring", -2, 1, {}},
      {"spring", -4, 0, {}},
      {"constant+damped-spring", Rational(9, 4), 3, {Rational(5, 2)}},
      // the same given as numbers
      {"damped-spring:k=4,c=4", 4, 4, {}},
      {"damped-spring:k=2,c=3", 2, 3, {}},
      {"damped-spring:k=-2,c=1", -2, 1, {}},
      {"spring:k=-4", -4, 0, {}},
      {"poly:1+damped-spring:k=9/4,c=3", Rational(9, 4), 3, {Rational(5, 2), 1}}};
  for (const Case& test : cases)
    for (const char* integrator : {"explicit-euler", "symplectic-euler", "velocity-verlet",
                                   "implicit-midpoint", "heun", "rk4", "adams-bashforth-2"}) {
      CAPTURE(test.force);
      CAPTURE(integrator);
      Motions m(find_integrator(integrator), test, Rational(1, 25));
      const LinearDerivation d = linear_derivation(m.program, m.force, parameter_values(m.program));
      CHECK(d.proved());
      const LinearKit kit = linear_kit(m.program, m.force, parameter_values(m.program));
      REQUIRE(kit.exists);
      check_every_frame(m, kit, 50);
    }
  const auto condition = [](const char* force) {
    return linear_flow(force_named(force), {"n", "h", "t", "k", "c"}).condition;
  };
  CHECK(condition("damped-spring:k=4,c=4") == "k = c^2/4, critically damped");
  CHECK(condition("damped-spring:k=2,c=3") == "k < c^2/4, overdamped");
  CHECK(condition("spring:k=-4") == "k < 0: unstable physics, the true motion itself runs away");
}

TEST_CASE("where the equations are quadratic, the square roots solve them") {
  const Precision precision(kDigits);
  for (const char* integrator : {"heun", "midpoint", "ralston"})
    for (const Case& test : kCases) {
      CAPTURE(integrator);
      CAPTURE(test.force);
      Motions m(find_integrator(integrator), test, Rational(1, 8));
      const LinearKit kit = linear_kit(m.program, m.force, parameter_values(m.program));
      REQUIRE(kit.implicit);
      CHECK_FALSE(kit.implicit->radicals.empty());
      for (const Definition& d : kit.definitions) m.values[d.name] = value(d.value, m.values);
      const Reals by_roots = m.values;
      solve_equations(kit, m.values);
      for (const char* name : {"k_new", "c_new"})
        if (by_roots.contains(name)) CHECK(close(by_roots.at(name), m.values.at(name)));
    }
}

TEST_CASE("roots of equations tend to the true values as the leading term says" *
          doctest::test_suite("thorough")) {
  const Precision precision(kDigits);
  int compared = 0;
  for (const Program& p : testing::short_catalogue())
    for (const char* force : {"spring", "damped-spring", "drag"}) {
      CAPTURE(p.name);
      CAPTURE(force);
      if (family(p) == "engines") continue;
      const LinearKit kit = linear_kit(p, force_named(force), parameter_values(p));
      if (!kit.exists || !kit.implicit) continue;
      if (!kit.extras.empty()) continue;  // no series with roots in the coefficients
      REQUIRE(kit.implicit->leading.size() == kit.implicit->unknowns.size());
      Motions m(p, {force, 3, force == std::string("spring") ? Rational(0) : Rational(2, 5), {1}},
                Rational(1, 100'000));
      for (const Definition& d : kit.definitions) m.values[d.name] = value(d.value, m.values);
      solve_equations(kit, m.values);
      for (std::size_t i = 0; i < kit.implicit->leading.size(); ++i) {
        const bool k = kit.implicit->unknowns[i] == kStiffness;
        const Real difference = m.values.at(k ? "k_new" : "c_new") - m.values.at(k ? "k" : "c");
        const Real leading = value(formula(kit.implicit->leading[i], kit.wording()), m.values);
        if (kit.implicit->leading[i].is_zero()) {
          CHECK(Real(abs(difference)) < decimal(Rational::parse("1e-40")));
          continue;
        }
        CHECK(Real(abs(Real(difference / leading - decimal(Rational(1))))) <
              decimal(Rational::parse("1e-3")));
        ++compared;
      }
    }
  CHECK(compared > 20);
}

TEST_CASE("the cases of the discrete motion, a double root and two real ones, agree with stepping") {
  const Precision precision(kDigits);
  // Symplectic Euler at the limit h^2 k = 4: T = -2, D = 1; beyond it two real roots. With damping, T^2 = 4 D
  // at h = 1, k = 1/4, c = 3/4: T = 1, D = 1/4.
  struct Discrete {
    Case test;
    Rational h;
    std::size_t which;
  };
  for (const Discrete& one :
       {Discrete{{"spring", 4, 0, {}}, 1, 0}, Discrete{{"spring", 9, 0, {}}, 1, 1},
        Discrete{{"spring", -1, 0, {}}, Rational(1, 2), 1},
        Discrete{{"constant+damped-spring", Rational(1, 4), Rational(3, 4), {2}}, 1, 0}}) {
    CAPTURE(one.test.force);
    Motions m(find_integrator("symplectic-euler"), one.test, one.h);
    const LinearDerivation d = linear_derivation(m.program, m.force);
    const Real half = value(formula(*d.trace, d.wording()), m.values) / 2;
    const Real discriminant = half * half - value(formula(*d.determinant, d.wording()), m.values);
    CHECK((one.which == 0 ? discriminant == 0 : discriminant > 0));
    if (one.which == 1) {
      m.values["z1"] = half + sqrt(discriminant);
      m.values["z2"] = half - sqrt(discriminant);
    }
    std::vector<Real> gamma;
    if (m.force.degree >= 0) gamma.push_back(decimal(Rational(1)));
    const auto frames = m.stepped(m.values.at("k"), m.zero_unless(m.force.damper, "c"), gamma,
                                  m.values.at("x0"), m.values.at("v0"), 20);
    for (const int n : {1, 2, 5, 20}) {
      m.values["n"] = decimal(Rational(n));
      m.values["t"] = m.values["n"] * m.values["h"];
      CHECK(close(value(d.cases.at(one.which).position, m.values), frames[n].first));
      CHECK(close(value(d.cases.at(one.which).velocity, m.values), frames[n].second));
    }
  }
}

TEST_CASE("where an implicit stage is singular is said") {
  const LinearDerivation d = linear_derivation(find_integrator("implicit-midpoint"), force_named("spring"));
  REQUIRE(d.singular.size() == 1);
  CHECK(d.singular[0].str(d.map.letters) == "h^2*k + 4");
  CHECK(linear_derivation(find_integrator("velocity-verlet"), force_named("spring")).singular.empty());
}
