// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/linear_kit.hpp"

#include <doctest/doctest.h>

#include <map>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

using namespace shortfall;
using Op = Expression::Op;

namespace {

constexpr int kDigits = 100;

using Reals = std::map<std::string, Real>;

/// A formula in numbers, by the library of MPFR and nothing of ours.
Real value(const Expr& e, const Reals& values) {
  const auto& o = e->operands;
  switch (e->op) {
    case Op::number:
      return real(e->value, kDigits);
    case Op::name:
      return values.at(e->name);
    case Op::negate:
      return -value(o[0], values);
    case Op::add:
      return value(o[0], values) + value(o[1], values);
    case Op::subtract:
      return value(o[0], values) - value(o[1], values);
    case Op::multiply:
      return value(o[0], values) * value(o[1], values);
    case Op::divide:
      return value(o[0], values) / value(o[1], values);
    case Op::power:
      return pow(value(o[0], values), value(o[1], values));
    case Op::call: {
      const Real x = value(o[0], values);
      if (e->name == "sqrt") return sqrt(x);
      if (e->name == "exp") return exp(x);
      if (e->name == "cos") return cos(x);
      if (e->name == "sin") return sin(x);
      if (e->name == "acos") return acos(x);
      break;
    }
    default:
      break;
  }
  FAIL("unexpected");
  return Real(0);
}

struct Case {
  const char* force;
  Rational k, c, a;
};

/// True motion, discrete motion by stepping, both at 100 digits.
struct Motions {
  const Program program;
  const Force force;
  Reals values;

  Motions(const std::string& integrator, const Case& test, const Rational& h)
      : program(find_integrator(integrator)), force(force_named(test.force)) {
    for (const auto& [name, number] : {std::pair{"k", test.k},
                                       {"c", test.c},
                                       {"a", test.a},
                                       {"h", h},
                                       {"x0", Rational(7, 5)},
                                       {"v0", Rational(-3, 4)}})
      values[name] = real(number, kDigits);
    for (const Definition& d : linear_flow(force, {"n", "h", "t", "k", "c"}).definitions)
      values[d.name] = value(d.value, values);
  }

  /// Positions and velocities after 0..steps steps, the letters k, c, a replaced by what the integrator is
  /// given.
  std::vector<std::pair<Real, Real>> stepped(const Real& k, const Real& c, const Real& a, const Real& x0,
                                             const Real& v0, int steps, int substeps = 1) const {
    Numbers<Real> problem;
    problem.force = [&](const Real& x, const Real& v, const Real&) -> Real {
      Real result = force.degree >= 0 ? a : real(Rational(0), kDigits);
      result = result - k * x;
      result = result - c * v;
      return result;
    };
    problem.round = [](const Rational& r) { return real(r, kDigits); };
    const Tape tape = lower(substepped(program, substeps));
    Run<Numbers<Real>> run(tape, problem, values.at("h"));
    run.begin(x0, v0, real(Rational(0), kDigits));
    std::vector<std::pair<Real, Real>> result{run.read_out()};
    for (int n = 0; n < steps; ++n) {
      run.step();
      result.push_back(run.read_out());
    }
    return result;
  }

  Real zero_unless(bool there, const char* name) const {
    return there ? values.at(name) : real(Rational(0), kDigits);
  }
};

bool close(const Real& a, const Real& b) {
  const Real scale = Real(abs(a)) + Real(abs(b)) + real(Rational(1), kDigits);
  return Real(abs(Real(a - b))) < scale * real(Rational::parse("1e-80"), kDigits);
}

}  // namespace

TEST_CASE("the closed forms with cos and sin agree with stepping over 200 steps at 100 digits") {
  const Precision precision(kDigits);
  const Case cases[] = {{"spring", 3, 0, 0},
                        {"damped-spring", 5, Rational(1, 3), 0},
                        {"constant+damped-spring", Rational(7, 2), Rational(2, 5), Rational(-981, 100)},
                        {"drag", 0, Rational(3, 7), Rational(-981, 100)},
                        {"constant+spring", 2, 0, Rational(5, 3)}};
  int compared = 0;
  for (const Program& p : catalogue())
    for (const Case& test : cases) {
      CAPTURE(p.name);
      CAPTURE(test.force);
      Motions m(p.name, test, Rational(1, 20));
      const LinearDerivation d = linear_derivation(m.program, m.force, parameter_values(m.program));
      CHECK(d.proved());
      if (!d.position) continue;
      bool oscillates = true;
      if (d.form.oscillation.order() == 2) {
        const auto& polynomial = d.form.oscillation.polynomial;  // z^2 - T z + D, in numbers
        const Real half =
            value(formula(polynomial[1], d.wording()), m.values) * real(Rational(-1, 2), kDigits);
        const Real discriminant = half * half - value(formula(polynomial[0], d.wording()), m.values);
        oscillates = discriminant < real(Rational(0), kDigits);
        if (!oscillates) {
          m.values["z1"] = half + sqrt(discriminant);
          m.values["z2"] = half - sqrt(discriminant);
        }
      }
      if (oscillates)
        for (const Definition& definition : d.definitions)
          m.values[definition.name] = value(definition.value, m.values);
      const auto states = m.stepped(m.zero_unless(m.force.spring, "k"), m.zero_unless(m.force.damper, "c"),
                                    m.values.at("a"), m.values.at("x0"), m.values.at("v0"), 200);
      for (const int n : {2, 3, 17, 200}) {
        m.values["n"] = real(Rational(n), kDigits);
        m.values["t"] = m.values["n"] * m.values["h"];
        if (oscillates) {
          CHECK(close(value(d.position, m.values), states[n].first));
          CHECK(close(value(d.velocity, m.values), states[n].second));
        } else {
          CHECK(close(value(d.cases[1].position, m.values), states[n].first));
        }
        ++compared;
      }
    }
  CHECK(compared > 300);
}

TEST_CASE("every kit that exists makes every frame exact: stepped at 100 digits against the true motion") {
  const Precision precision(kDigits);
  const Case cases[] = {{"spring", 3, 0, 0},
                        {"damped-spring", 5, Rational(1, 3), 0},
                        {"constant+damped-spring", Rational(7, 2), Rational(2, 5), Rational(-981, 100)},
                        {"drag", 0, Rational(3, 7), Rational(-981, 100)},
                        {"constant+spring", 2, 0, Rational(5, 3)}};
  int repaired = 0;
  for (const Program& p : catalogue())
    for (const Case& test : cases)
      for (const int substeps : {1, 2}) {
        if (substeps > 1 && family(p) != "euler") continue;
        CAPTURE(p.name);
        CAPTURE(test.force);
        Motions m(p.name, test, Rational(1, 20));
        const LinearKit kit = linear_kit(m.program, m.force, parameter_values(m.program), substeps);
        if (!kit.exists) {
          CHECK_FALSE(kit.obstruction.empty());
          continue;
        }
        ++repaired;
        for (const Definition& d : kit.definitions) m.values[d.name] = value(d.value, m.values);
        Real k = m.zero_unless(m.force.spring, "k");
        Real c = m.zero_unless(m.force.damper, "c");
        Real a = m.values.at("a");
        Real v0 = m.values.at("v0");
        Expr read_out = name("v_n");
        for (const LinearCorrection& correction : kit.corrections) {
          if (correction.kind == LinearCorrection::Kind::read_out) {
            read_out = correction.value;
            continue;
          }
          const Real replaced = value(correction.value, m.values);
          (correction.target == "k"   ? k
           : correction.target == "c" ? c
           : correction.target == "a" ? a
                                      : v0) = replaced;
        }
        const auto states = m.stepped(k, c, a, m.values.at("x0"), v0, 200, substeps);
        const LinearFlow flow = linear_flow(m.force, {"n", "h", "t", "k", "c"});
        for (const int n : {1, 2, 3, 50, 200}) {
          m.values["t"] = real(Rational(n), kDigits) * m.values["h"];
          m.values["x_n"] = states[n].first;
          m.values["v_n"] = states[n].second;
          CHECK(close(states[n].first, value(flow.position, m.values)));
          CHECK(close(value(read_out, m.values), value(flow.velocity, m.values)));
        }
      }
  CHECK(repaired > 50);
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
