// SPDX-License-Identifier: GPL-3.0-or-later
// Kits and conserved forms that are known from the literature, and what cannot be.
#include <doctest/doctest.h>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "tests/correction/linear_motions.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;
using namespace shortfall::linear;

TEST_CASE("what a stiffness alone can do, and cannot") {
  const auto kit = [](const char* integrator) {
    return linear_kit(find_integrator(integrator), force_named("spring"));
  };
  // Trace and determinant of rk4 cannot both be matched by k: the determinant 1 - y^3/72 + y^4/576 would have
  // to be 1.
  const LinearKit rk4 = kit("rk4");
  REQUIRE(rk4.exists);
  REQUIRE(rk4.notes.size() == 1);
  CHECK(rk4.notes[0].find("the determinant of the step is 1/576*y^4 - 1/72*y^3 + 1") != std::string::npos);
  REQUIRE(rk4.implicit);
  CHECK(rk4.implicit->unknowns == std::vector<Letter>{kStiffness, kDamping});
  CHECK_FALSE(rk4.implicit->jacobian.is_zero());
  // Ruth's third-order method keeps areas: k alone, a root of a cubic, for every step up to its stability
  // limit.
  const LinearKit ruth = kit("ruth3");
  REQUIRE(ruth.implicit);
  CHECK(ruth.notes.empty());
  CHECK(ruth.implicit->equations[0].degree(kStiffness) == 3);
  REQUIRE(ruth.implicit->range);
  CHECK(ruth.implicit->range->all);
  // Explicit Euler: both, by rational functions.
  const LinearKit euler = kit("explicit-euler");
  CHECK_FALSE(euler.implicit);
  CHECK(print(euler.corrections[0].value) == "-2*(C - 1)/h^2");
  CHECK(print(euler.corrections[1].value) == "-2*(C - 1)/h");
}

TEST_CASE("rk4 under drag can be repaired as long as its own decay reaches the true one") {
  const LinearKit kit = linear_kit(find_integrator("rk4"), force_named("drag"));
  REQUIRE(kit.implicit);
  REQUIRE(kit.implicit->range);
  CHECK_FALSE(kit.implicit->range->all);
  // 1 - d + d^2/2 - d^3/6 + d^4/24 is least where 1 - d + d^2/2 - d^3/6 = 0: then d^4/24 is left.
  const Rational d = Rational::parse(kit.implicit->range->end->significant(30));
  CHECK((Rational(1) - d + d * d / 2 - d * d * d / 6).abs() < Rational(10).pow(-28));
  CHECK((Rational::parse(*kit.implicit->range->least) - d.pow(4) / 24).abs() < Rational(10).pow(-18));
}

TEST_CASE("integrators that cannot be repaired are told why") {
  const auto kit = [](const char* step, const char* force) {
    return linear_kit(parse(std::string("integrator mine\nstep\n") + step, "mine.integrator"),
                      force_named(force));
  };
  // It never looks at the force.
  const LinearKit blind = kit("  x = x + h*v\n", "spring");
  CHECK_FALSE(blind.exists);
  CHECK(blind.impossible);
  CHECK(blind.obstruction.find("no choice of k_new and c_new changes") != std::string::npos);
  REQUIRE(blind.notes.size() == 1);
  CHECK(blind.notes[0].find("no choice of k_new changes") != std::string::npos);
  // Its velocity does not move the position: no pair of first positions but constant ones.
  const LinearKit stuck = kit("  x = x\n  v = v + h*a(x, v, t)\n", "damped-spring");
  CHECK_FALSE(stuck.exists);
  CHECK(stuck.impossible);
  // Under drag alone it has the right eigenvalues, and still stands.
  const LinearKit standing = kit("  x = x\n  v = v + h*a(x, v, t)\n", "drag");
  CHECK_FALSE(standing.exists);
  CHECK(standing.impossible);
  CHECK(standing.obstruction.find("Jordan form") != std::string::npos);
}

TEST_CASE("gravity with drag: the formulas of the literature, and the read-out") {
  const Precision precision(kDigits);
  // v = g/c + (v_n - g/c) c h/(e^(c h) - 1), v0' = [(x(h) - x0)/h - h g~]/D
  const LinearKit kit = linear_kit(find_integrator("symplectic-euler"), force_named("drag"));
  Reals v{{"h", decimal(Rational(1, 7))}, {"c", decimal(Rational(3, 5))},  {"a", decimal(Rational(-49, 5))},
          {"x0", decimal(Rational(1))},   {"v0", decimal(Rational(4, 3))}, {"v_n", decimal(Rational(-2, 3))},
          {"x_n", decimal(Rational(5))}};
  for (const Definition& d : kit.definitions) v[d.name] = value(d.value, v);
  const Real ch = v["c"] * v["h"], terminal = v["a"] / v["c"];
  const Real pushed = v["a"] * Real(decimal(Rational(1)) - v["D"]) / ch;
  const Real moved =
      terminal * v["h"] + Real(v["v0"] - terminal) * Real(decimal(Rational(1)) - v["D"]) / v["c"];
  for (const LinearCorrection& c : kit.corrections) {
    const Real found = value(c.value, v);
    if (c.target == "a") CHECK(close(found, pushed));
    if (c.target == "v0") CHECK(close(found, Real(moved / v["h"] - v["h"] * pushed) / v["D"]));
    if (c.target == "v")
      CHECK(close(found, terminal + Real(v["v_n"] - terminal) * ch / Real(exp(ch) - decimal(Rational(1)))));
  }
}

TEST_CASE("what the energy is multiplied by, from the first step on or later") {
  const auto derived = [](const char* integrator) {
    return linear_derivation(find_integrator(integrator), force_named("spring"));
  };
  CHECK(derived("beeman").amplified_from == 1);
  CHECK(quadratic_form(derived("beeman").amplification)->factor == Fraction(1));
  CHECK(quadratic_form(derived("stoermer-verlet-wrong-start").amplification)->xx ==
        quadratic_form(derived("stoermer-verlet").amplification)->xx);
  CHECK(derived("adams-bashforth-2").amplification.empty());
}

TEST_CASE("the quadratic form is multiplied by its factor in every exact step, for the whole catalogue") {
  int checked = 0;
  for (const Program& p : testing::short_catalogue())
    for (const char* force : {"spring:k=3", "damped-spring:k=2,c=1/3"}) {
      CAPTURE(p.name);
      const Force f = force_named(force);
      const Values parameters = parameter_values(p);
      const LinearDerivation d = linear_derivation(p, f, parameters);
      const auto q = quadratic_form(d.amplification);
      if (!q) continue;
      // Roots and long decimals have no short exact steps: 100 digits then.
      const Precision precision(kDigits);
      const NumberField field(d.map.generators);
      const Rational h(1, 3);
      const Rational k = *f.k, c = f.c.value_or(0);
      Reals letters{{"h", decimal(h)}};
      for (const ExtraLetters::Extra& e : d.map.extras)
        if (e.root) letters[e.name] = decimal(near(*e.root, 2 * kDigits));
      for (const auto& [name, number] : parameters) letters[name] = decimal(number);
      const auto in_numbers = [&](const Fraction& g) { return value(formula(g, d.wording()), letters); };
      const Real xx = in_numbers(q->xx), xv = in_numbers(q->xv), factor = in_numbers(q->factor);
      Motions m(p, {force, k, c, {}}, h);
      const auto frames =
          m.stepped(decimal(k), decimal(c), {}, decimal(Rational(7, 5)), decimal(Rational(-3, 4)), 12);
      Real before = decimal(Rational(0));
      for (int n = 0; n <= 12; ++n) {
        const auto& [x, v] = frames[n];
        const Real now = xx * x * x + xv * x * v + v * v;
        if (n > d.amplified_from) CHECK(close(now, Real(before * factor)));
        before = now;
      }
      ++checked;
    }
  CHECK(checked > 40);
}

TEST_CASE("the kits of the literature come out") {
  const auto value_of = [](const LinearKit& kit, LinearCorrection::Kind kind,
                           const std::string& target) -> std::string {
    for (const LinearCorrection& c : kit.corrections)
      if (c.kind == kind && c.target == target) return print(c.value);
    return "";
  };
  const LinearKit verlet = linear_kit(find_integrator("velocity-verlet"), force_named("spring"));
  CHECK(verlet.exists);
  CHECK(value_of(verlet, LinearCorrection::Kind::parameter, "k") == "-2*(C - 1)/h^2");  // 4/h^2 sin^2(w h/2)
  CHECK(value_of(verlet, LinearCorrection::Kind::launch, "v0") == "S/h*v0");            // sin(w h)/(w h) v0
  const LinearKit damped = linear_kit(find_integrator("symplectic-euler"), force_named("damped-spring"));
  CHECK(value_of(damped, LinearCorrection::Kind::parameter, "c") == "-(D - 1)/h");
  const LinearKit drag = linear_kit(find_integrator("symplectic-euler"), force_named("drag"));
  CHECK(value_of(drag, LinearCorrection::Kind::parameter, "a") == "-(D - 1)/(h*c)*a");
}

TEST_CASE("quadratic forms of the literature are conserved") {
  const auto form = [](const std::string& integrator) {
    const LinearDerivation d = linear_derivation(find_integrator(integrator), force_named("spring"));
    const auto q = quadratic_form(d.amplification);
    REQUIRE(q);
    const std::vector<std::string> letters = d.map.letters;
    return std::tuple{q->xx.str(letters), q->xv.str(letters), q->factor.str(letters)};
  };
  CHECK(form("symplectic-euler") == std::tuple{"k", "-h*k", "1"});
  CHECK(form("symplectic-euler-drift-kick") == std::tuple{"k", "h*k", "1"});
  CHECK(form("velocity-verlet") == std::tuple{"-1/4*h^2*k^2 + k", "0", "1"});
  CHECK(form("explicit-euler") == std::tuple{"k", "0", "h^2*k + 1"});
}

TEST_CASE("forces are read exactly, and bad ones refused with a sentence") {
  CHECK(force_named("spring:k=4").stiffness() == Fraction(4));
  CHECK_FALSE(force_named("spring:k=0").linear());
  CHECK(force_named("damped-spring:k=4,c=0").damper == false);
  CHECK(force_named("drag").degree == 0);
  CHECK(force_named("poly:2+spring").degree == 2);
  CHECK_THROWS_WITH_AS(force_named("sprng"),
                       "unknown force 'sprng'; did you mean 'spring'? (the forces are constant, poly:D, "
                       "spring, damped-spring, drag, and sums such as constant+spring)",
                       BadInput);
  CHECK_THROWS_AS(force_named("spring:c=1"), BadInput);
  CHECK_THROWS_AS(force_named("poly:-1"), BadInput);
  CHECK_THROWS_AS(force_named("spring:k=1/0"), BadInput);
  CHECK_THROWS_AS(force_named(""), BadInput);
}
