// SPDX-License-Identifier: GPL-3.0-or-later
// Integrators that damp themselves: kits held against plain stepping in 100 digits, the true motion by its
// power series in t, which shares nothing with what derives the formulas.
#include "analysis/motion/own_equation.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/correction/kit_numbers.hpp"
#include "analysis/motion/claims.hpp"
#include "analysis/motion/verify.hpp"
#include "analysis/problems/letters.hpp"
#include "analysis/program/parse.hpp"
#include "tests/correction/linear_motions.hpp"

using namespace shortfall;
using namespace shortfall::linear;

namespace {

// One-step maps of engines, as in their sources.
const std::map<std::string, std::string> kMaps = {
    {"damp-last",
     "param c : 1/T = 0\nassume 1 - c*h > 0\nsolves a(x, v, t) - c*v\nstep\n"
     "v = (v + h*a(x, v, t))*max(0, 1 - c*h)\nx = x + h*v"},
    {"damp-first",
     "param c : 1/T = 1/10\nassume 1 - c*h > 0\nsolves a(x, v, t) - c*v\nstep\n"
     "v = max(0, 1 - c*h)*v + h*a(x, v, t)\nx = x + h*v"},
    {"implicit-damping",
     "param c : 1/T = 0\nsolves a(x, v, t) - c*v\nstep\nv = (v + h*a(x, v, t))/(1 + c*h)\nx = x + h*v"},
    {"substeps-then-damping",
     "param c : 1/T = 0\nhold a\nsolves a(x, v, t) - c*v\nstep\n"
     "substeps 4 {\nv = v + h*a(x, v, t)\nx = x + h*v\n}\nv = 1/(1 + c*h)*v"},
    {"damping-in-substeps",
     "param c : 1/T = 0\nparam N = 4\nhold a\nsolves a(x, v, t) - c*v\nstep\n"
     "substeps N {\nv = h*a(x, v, t) + 1/(1 + c*h)*v\nx = x + h*v\n}"},
    {"power",
     "param c = 0\nassume 1 - c > 0\nsolves a(x, v, t) + log(1 - c)*v\nstep\n"
     "v = v*pow(1 - c, h) + h*a(x, v, t)\nx = x + h*v"},
    {"power-drift-first",
     "param c = 0\nassume 1 - c > 0\nsolves a(x, v, t) + log(1 - c)*v\nstep\n"
     "f = a(x, v, t)\nx = x + h*v\nv = pow(1 - c, h)*v + h*f"},
    {"power-twice",
     "param c = 0\nassume 1 - c > 0\nsolves a(x, v, t) + log(1 - c)*v\nstep\n"
     "v = v*pow(1 - c, h)*pow(1 - c, h) + h*a(x, v, t)\nx = x + h*v"},
    {"exponential",
     "param r : 1/T = 0\nsolves a(x, v, t) - r*v\nstep\nv = v*exp(-r*h) + h*a(x, v, t)\nx = x + h*v"},
    {"by-mass",
     "param b : 1/T = 1\nparam m = 2\nsolves a(x, v, t) - b/m*v\nstep\n"
     "v = v + h*(a(x, v, t) - b/m*v)\nx = x + h*v"},
    {"own-spring",
     "param b : 1/T = 1\nparam s : 1/T^2 = 1\nsolves a(x, v, t) - b*v - s*x\nstep\n"
     "v = (v + h*(a(x, v, t) - s*x))/(1 + h*b)\nx = x + h*v"},
};

Program map(const std::string& name) {
  return parse("integrator " + name + "\n" + kMaps.at(name) + "\n", name);
}

/// x and v after t under f0 + f1 t - k x - c v, by the power series.
std::pair<Real, Real> truth(const Reals& v, const Real& k, const Real& c, const Real& t) {
  Real a = v.at("x0"), b = v.at("v0"), power = decimal(1);
  Real x = decimal(0), speed = decimal(0);
  for (int j = 0; j < 500; ++j) {
    const Real dx = Real(a * power), dv = Real(b * power) * decimal(j + 1);
    x = x + dx;
    speed = speed + dv;
    const Real push = j == 0 ? v.at("f0") : j == 1 ? v.at("f1") : decimal(0);
    const Real ka = k * a, cb = Real(c * b) * decimal(j + 1);
    const Real next = Real(Real(push - ka) - cb) / decimal((j + 1) * (j + 2));
    a = b;
    b = next;
    power = power * t;
  }
  return {x, speed};
}

/// A number of 95 digits, exactly.
Rational exactly(const Real& x) { return Rational::parse(x.str(95, std::ios_base::scientific)); }

/// Steps the integrator with its parameters and the force f0 + f1 t - k x - c v.
std::vector<std::pair<Real, Real>> frames(const Program& program, const Values& parameters, const Real& f0,
                                          const Real& f1, const Real& k, const Real& c, const Real& x0,
                                          const Real& v0, const Rational& h, int steps, int substeps) {
  Numbers<Real> problem;
  problem.force = [&](const Real& x, const Real& v, const Real& time) -> Real {
    const Real slope = f1 * time, pull = k * x, drag = c * v;
    return Real(Real(Real(f0 + slope) - pull) - drag);
  };
  problem.round = [](const Rational& r) { return decimal(r); };
  const Tape tape = lower(substepped(program, substeps), parameters);
  Run<Numbers<Real>> run(tape, problem, decimal(h));
  run.begin(x0, v0, decimal(0));
  std::vector<std::pair<Real, Real>> result{run.read_out()};
  for (int n = 0; n < steps; ++n) {
    run.step();
    result.push_back(run.read_out());
  }
  return result;
}

struct Trial {
  std::string map;
  std::string force;
  Values parameters;
  Rational damping;  // the rate c of the true motion, and its stiffness
  Rational stiffness;
  int substeps = 1;
};

/// Every frame of the corrected integrator is on the true motion; returns by how much the parameter moved.
void check(const Trial& t) {
  CAPTURE(t.map);
  CAPTURE(t.force);
  CAPTURE(t.substeps);
  const Program program = map(t.map);
  const Rational h(1, 30);
  const Force asked = force_named(t.force);
  const LinearDerivation d = linear_derivation(program, asked, t.parameters, t.substeps);
  CHECK(d.proved());
  const LinearKit kit = linear_kit(program, asked, t.parameters, t.substeps);
  CAPTURE(kit.obstruction);
  REQUIRE(kit.exists);
  Reals values{{"h", decimal(h)},
               {"x0", decimal(Rational(7, 5))},
               {"v0", decimal(Rational(-3, 4))},
               {"f0", decimal(asked.degree >= 0 ? Rational(-981, 100) : Rational())},
               {"f1", decimal(asked.degree >= 1 ? Rational(2, 3) : Rational())}};
  const bool power = t.map.starts_with("power");
  const Real k = decimal(t.stiffness);
  const Real c = power ? Real(-log(Real(decimal(1) - decimal(t.parameters.at("c"))))) : decimal(t.damping);
  values["a"] = values["f"] = values["f0"];
  values["f'"] = values["f1"];
  // The numbers of the kit, roots of equations included, come from interval Newton steps of their own.
  const Force whole = with_own_equation(asked, program, t.parameters);
  const KitNumbers numbers = kit_numbers(kit, whole, parameter_values(program, t.parameters), h, 60);
  const auto evaluated = [&](const NumericCorrection& correction, const Reals& at) {
    Real sum = decimal(0);
    for (const auto& [number, name] : correction.terms)
      sum = sum + real(number.ball.midpoint(), kDigits) * (name.empty() ? decimal(1) : at.at(name));
    return sum;
  };
  Values parameters = t.parameters;
  Real stiffness = asked.spring ? k : decimal(0), damping = decimal(0);
  Real f0 = values["f0"], f1 = values["f1"], x0 = values["x0"], v0 = values["v0"];
  const NumericCorrection* read_out = nullptr;
  for (std::size_t i = 0; i < kit.corrections.size(); ++i) {
    const NumericCorrection& n = numbers.corrections[i];
    if (kit.corrections[i].kind == LinearCorrection::Kind::read_out) {
      read_out = &n;
    } else if (n.target == "a" || n.target == "f") {
      f0 = evaluated(n, values);  // f~(0), and its slope from the derivative of f alone
      Reals slope = values;
      slope["f"] = values["f1"];
      slope["f'"] = decimal(0);
      if (asked.degree >= 1) f1 = evaluated(n, slope);
    } else if (n.target == "v0") {
      v0 = evaluated(n, values);
    } else if (n.target == "x0") {
      x0 = evaluated(n, values);
    } else if (n.target == "k") {
      stiffness = evaluated(n, values);
    } else if (n.target == "c" && power && asked.spring) {  // of the force; the integrator keeps its own
      damping = evaluated(n, values);
    } else {
      CHECK(program.parameter(n.target));
      parameters[n.target] = exactly(evaluated(n, values));
    }
  }
  const int steps = 60;
  const auto stepped = frames(program, parameters, f0, f1, stiffness, damping, x0, v0, h, steps, t.substeps);
  REQUIRE(read_out);
  for (const int n : {0, 1, 2, 3, 17, steps}) {
    CAPTURE(n);
    const Real time = decimal(h * Rational(n));
    const auto [x, v] = truth(values, k, c, time);
    Reals at = values;
    at["x_n"] = stepped[n].first;
    at["v_n"] = stepped[n].second;
    at["f"] = at["a"] = Real(values["f0"] + Real(values["f1"] * time));
    const auto near = [](const Real& a, const Real& b) {
      return Real(abs(Real(a - b))) < decimal(Rational::parse("1e-50"));
    };
    CHECK(near(stepped[n].first, x));
    CHECK(near(evaluated(*read_out, at), v));
  }
  // Without the kit it is not so.
  const auto plain = frames(program, t.parameters, values["f0"], values["f1"], asked.spring ? k : decimal(0),
                            decimal(0), values["x0"], values["v0"], h, steps, t.substeps);
  CHECK(Real(abs(Real(plain[steps].first - truth(values, k, c, decimal(h * steps)).first))) >
        decimal(Rational::parse("1e-9")));
}

}  // namespace

TEST_CASE("kits of integrators that damp themselves make every frame exact") {
  const Precision precision(kDigits);
  for (const char* name :
       {"damp-last", "damp-first", "implicit-damping", "substeps-then-damping", "damping-in-substeps"}) {
    const Values c{{"c", Rational(3, 7)}};
    check({name, "drag", c, Rational(3, 7), 0});
    check({name, "poly:1", c, Rational(3, 7), 0});
    check({name, "damped-spring:k=5/2", c, Rational(3, 7), Rational(5, 2)});
  }
  for (const char* name : {"power", "power-drift-first"}) {
    check({name, "constant", {{"c", Rational(3, 7)}}, 0, 0});
    check({name, "poly:1+drag", {{"c", Rational(1, 9)}}, 0, 0});
  }
  check({"power", "spring:k=5/2", {{"c", Rational(3, 7)}}, 0, Rational(5, 2)});
  check({"exponential", "constant", {{"r", Rational(2, 3)}}, Rational(2, 3), 0});
  check({"exponential", "constant+spring:k=3", {{"r", Rational(2, 3)}}, Rational(2, 3), 3});
  check({"by-mass", "drag", {{"b", 1}, {"m", Rational(5, 2)}}, Rational(2, 5), 0});
  check({"own-spring", "constant", {{"b", Rational(1, 2)}, {"s", 3}}, Rational(1, 2), 3});
}

TEST_CASE("damping in substeps: the parameter is rational in the share that one substep leaves") {
  const Precision precision(kDigits);
  const LinearKit kit = linear_kit(map("damping-in-substeps"), force_named("drag"));
  CHECK(print(kit.corrections.at(0).value) == "-4*(d - 1)/(h*d)");
  CHECK_FALSE(kit.implicit);
  check({"damp-last", "drag", {{"c", Rational(3, 7)}}, Rational(3, 7), 0, 3});
  check({"power", "constant", {{"c", Rational(3, 7)}}, 0, 0, 3});
}

TEST_CASE("the damping and the launch of the maps with one kick are those of the literature's damped body") {
  // v <- (v + h a)(1 - c~ h), x <- x + h v: (1 - c~ h) = e^(-c h).
  const LinearKit last = linear_kit(map("damp-last"), force_named("drag"));
  CHECK(print(last.corrections.at(0).value) == "-(D - 1)/h");
  CHECK(last.corrections.at(0).target == "c");
  // v <- (v + h a)/(1 + c~ h): 1/(1 + c~ h) = e^(-c h).
  CHECK(print(linear_kit(map("implicit-damping"), force_named("drag")).corrections.at(0).value) ==
        "-(D - 1)/(h*D)");
}

TEST_CASE("a step that takes its decay exactly says so and has nothing to tune") {
  const LinearKit kit = linear_kit(map("power"), force_named("constant"));
  REQUIRE(kit.notes.size() == 1);
  CHECK(kit.notes[0].find("without a force every velocity is exact already") != std::string::npos);
  for (const LinearCorrection& c : kit.corrections) CHECK(c.target != "c");
  CHECK(linear_kit(map("exponential"), force_named("drag")).notes.size() == 1);
  CHECK(linear_kit(map("damp-last"), force_named("drag")).notes.empty());
}

TEST_CASE(
    "a step whose own decay a stiffness cannot mend says why, and takes a damping of the force besides") {
  const Precision precision(kDigits);
  const auto note = [](const char* name) {
    const LinearKit kit = linear_kit(map(name), force_named("spring"));
    REQUIRE(kit.notes.size() == 1);
    return kit.notes[0];
  };
  // It damps twice: its determinant is D^2 whatever the stiffness.
  CHECK(note("power-twice") ==
        "a stiffness alone is not enough: no choice of k_new changes the difference D^2 - D");
  CHECK(note("power-drift-first").find("it changes the determinant of the step") != std::string::npos);
  for (const char* name : {"power-twice", "power-drift-first"})
    check({name, "constant+spring:k=5/2", {{"c", Rational(3, 7)}}, 0, Rational(5, 2)});
}

TEST_CASE("the true motion is the integrator's own equation together with the force") {
  const auto force = [](const std::string& name, const std::string& text, const Values& given = {}) {
    return with_own_equation(force_named(text), map(name), given);
  };
  for (const char* text : {"constant", "drag", "poly:2", "spring", "damped-spring"})
    CHECK(force("damp-last", text).own_c);
  CHECK(force("damp-last", "constant", {{"c", Rational(1, 3)}}).c == Rational(1, 3));
  CHECK(force("by-mass", "constant", {{"b", 3}, {"m", 4}}).c == Rational(3, 4));
  // Switched off, it leaves the damping to the force.
  CHECK_FALSE(force("damp-last", "constant", {{"c", 0}}).linear());
  CHECK(force("damp-last", "drag:c=1/2", {{"c", 0}}).c == Rational(1, 2));
  CHECK_FALSE(force("damp-last", "drag:c=1/2", {{"c", 0}}).own_c);
  CHECK(linear_kit(map("implicit-damping"), force_named("spring:k=3"), {{"c", 0}}).exists);
  CHECK(force("own-spring", "constant").spring);
  CHECK_THROWS_WITH_AS(
      force("damp-last", "drag:c=1/2"),
      "'damp-last' has damping of its own: its number is given by --param c; leave c out of the "
      "force",
      BadInput);
  CHECK_THROWS_AS(force("own-spring", "spring:k=1"), BadInput);
  // Without `solves` nothing changes.
  const Program euler = find_integrator("symplectic-euler");
  CHECK(with_own_equation(force_named("drag:c=1/2"), euler, {}).c == Rational(1, 2));
  CHECK_FALSE(with_own_equation(force_named("constant"), euler, {}).linear());
}

TEST_CASE("equations that are not linear are refused") {
  const auto of = [](const std::string& solves) {
    const Program p =
        parse("integrator e\nparam c : 1/T = 1\nsolves " + solves + "\nstep\nx = x + h*v\n", "e");
    return with_own_equation(force_named("constant"), p, {});
  };
  CHECK_THROWS_AS(of("2*a(x, v, t) - c*v"), Unable);
  CHECK_THROWS_AS(of("a(x, v, t) + c*c*c*x*t"), Unable);
  CHECK_THROWS_AS(of("a(x, 2*v, t)"), Unable);
  CHECK(of("a(x, v, t) - c*(v + v)").own_c == Fraction(2) * Fraction::letter(kFirstParameter));
}

TEST_CASE("formulas for integrators that damp themselves are proved and refuted") {
  const Program p = map("damp-last");
  const Derivation d = derivation(p, 0, {}, 1, false);
  CHECK(d.proof.proved);
  CHECK(d.check.agrees);
  const Names names = formula_names(p, 0);
  const auto verdict_on = [&](const char* text) {
    return verdict(d, p, {}, parse_formula(text, "--v", names, {Sort::vector, kVelocity}), false);
  };
  CHECK(verdict_on("v0*(1 - c*h)^n + a*(1 - c*h)/c*(1 - (1 - c*h)^n)").proved);
  CHECK_FALSE(verdict_on("v0*(1 - c*h)^n + a/c*(1 - (1 - c*h)^n)").proved);
}
