// SPDX-License-Identifier: GPL-3.0-or-later
// Integrators whose coefficients are roots, or that damp by themselves, by exp or in a quotient: letters that
// are numbers, and letters that are free.
#include "analysis/correction/kit_numbers.hpp"
#include "analysis/program/parse.hpp"
#include "tests/correction/linear_motions.hpp"

using namespace shortfall;
using namespace shortfall::linear;

namespace {

const char* const kForestRuth = R"(integrator fr
  root q of q^3 = 2
step
  x = x + h/(2*(2-q))*v
  v = v + h/(2-q)*a(x, v, t)
  x = x + h*(1-q)/(2*(2-q))*v
  v = v - h*q/(2-q)*a(x, v, t)
  x = x + h*(1-q)/(2*(2-q))*v
  v = v + h/(2-q)*a(x, v, t)
  x = x + h/(2*(2-q))*v
)";

const char* const kDampsByExp = R"(integrator ex
  param g : 1/T = 1/10
step
  v = exp(-g*h)*(v + h*a(x, v, t))
  x = x + h*v
)";

const char* const kDampsByItself = R"(integrator engine
  param g : 1/T = 1/10
step
  v = (v + h*a(x, v, t))/(1 + g*h)
  x = x + h*v
)";

const char* const kSquareRoot = R"(integrator sq
step
  x1 = x + (1 - sqrt(2)/2)*h*v
  v  = v + h*a(x1, v, t)
  x  = x1 + sqrt(2)/2*h*v
)";

const std::vector<Case> kThreeForces = {{"spring", 3, 0, {}},
                                        {"constant+damped-spring", 4, Rational(1, 3), {2}},
                                        {"drag", 0, Rational(2, 3), {Rational(-981, 100)}}};

}  // namespace

TEST_CASE("kits of integrators with roots and with exp make every frame exact") {
  const Precision precision(kDigits);
  for (const char* text : {kForestRuth, kDampsByExp, kDampsByItself, kSquareRoot})
    for (const Case& test : kThreeForces) {
      CAPTURE(text);
      CAPTURE(test.force);
      const Program p = parse(text, "mine.integrator");
      Motions m(p, test, Rational(1, 20));
      m.values["g"] = decimal(Rational(1, 10));
      // Parameters left open, and given as numbers.
      for (const Values& given : {Values{}, parameter_values(p)}) {
        const LinearKit kit = linear_kit(p, m.force, given);
        CAPTURE(kit.obstruction);
        REQUIRE(kit.exists);
        Motions fresh = m;
        check_every_frame(fresh, kit, 50);
      }
    }
}

TEST_CASE("Forest and Ruth's method keeps areas: a stiffness alone, though its coefficients are irrational") {
  const Program p = parse(kForestRuth, "mine.integrator");
  const LinearKit kit = linear_kit(p, force_named("spring"));
  REQUIRE(kit.exists);
  CHECK(kit.notes.empty());
  REQUIRE(kit.implicit);
  CHECK(kit.implicit->unknowns == std::vector<Letter>{kStiffness});
  REQUIRE(kit.conserved);
  CHECK(kit.conserved->factor == Fraction(1));
  // A palindrome needs no shift of the velocity by the position.
  for (const LinearCorrection& c : kit.corrections)
    if (c.target == "v0") CHECK_FALSE(mentions(c.value, "x0"));
}

TEST_CASE(
    "numbers after many steps of integrators with roots and with exp agree with stepping at 100 digits") {
  const Precision precision(kDigits);
  for (const char* text : {kForestRuth, kDampsByExp, kDampsByItself, kSquareRoot})
    for (const char* force : {"spring:k=3", "constant:a=2+damped-spring:k=4,c=1/3"}) {
      CAPTURE(text);
      CAPTURE(force);
      const Program p = parse(text, "mine.integrator");
      NumericQuestion q;
      q.force = force_named(force);
      q.h = Rational(1, 20);
      q.x0 = Rational(7, 5);
      q.v0 = Rational(-3, 4);
      q.steps = 150;
      const NumericMotion m = numeric_motion(p, q);
      const Case test{force, *q.force.k, q.force.c.value_or(0), {2}};
      const Motions motions(p, test, q.h);
      std::vector<Real> gamma;
      if (q.force.degree == 0) gamma.push_back(decimal(Rational(1)));
      const auto frames =
          motions.stepped(decimal(test.k), decimal(test.c), gamma, decimal(q.x0), decimal(q.v0), 150);
      REQUIRE(m.position.decimal);
      CHECK(Real(abs(Real(frames[150].first - decimal(Rational::parse(*m.position.decimal))))) <
            decimal(Rational::parse("1e-48")));
      CHECK(Real(abs(Real(frames[150].second - decimal(Rational::parse(*m.velocity.decimal))))) <
            decimal(Rational::parse("1e-48")));
      // The kit in numbers, too.
      const LinearKit kit = linear_kit(p, q.force);
      REQUIRE(kit.exists);
      CHECK_NOTHROW(kit_numbers(kit, q.force, parameter_values(p), q.h));
    }
}

TEST_CASE("the engines of the catalogue have kits, and those make every frame exact") {
  const Precision precision(kDigits);
  int repaired = 0;
  for (const char* engine :
       {"box2d-2", "bullet", "godot", "jolt", "matter-js", "physx", "rapier", "ode", "mujoco-rk4"})
    for (const Case& test : kThreeForces) {
      CAPTURE(engine);
      CAPTURE(test.force);
      Program p = find_integrator(engine);
      for (Parameter& own : p.parameters)  // what damps of its own is held against its own equation elsewhere
        if (own.name == "c") own.fallback = number(0);
      Motions m(p, test, Rational(1, 60));
      const LinearKit kit = linear_kit(p, m.force, parameter_values(p));
      CAPTURE(kit.obstruction);
      CHECK(kit.exists);
      if (!kit.exists) continue;
      check_every_frame(m, kit, 20);
      ++repaired;
    }
  CHECK(repaired > 20);
}
