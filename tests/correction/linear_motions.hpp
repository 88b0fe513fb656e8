// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Linear motions in numbers of 100 digits: formulas evaluated by MPFR's functions, steps by the interpreter.
// Nothing of what derives the formulas is used.
#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/real.hpp"
#include "analysis/correction/linear_kit.hpp"
#include "analysis/problems/functions.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"

namespace shortfall::linear {

constexpr int kDigits = 100;

using Reals = std::map<std::string, Real>;

inline Real decimal(const Rational& r) { return real(r, kDigits); }

/// A formula in numbers.
inline Real value(const Expr& e, const Reals& values) {
  using Op = Expression::Op;
  const auto& o = e->operands;
  switch (e->op) {
    case Op::number:
      return decimal(e->value);
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
      if (e->name == "cosh") return cosh(x);
      if (e->name == "sinh") return sinh(x);
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
  std::string force;
  Rational k, c;
  std::vector<Rational> push;  // a, or f0, f1, ...
};

/// The integrator and the true motion with numbers for all letters.
struct Motions {
  Program program;
  Force force;
  Case test;
  Reals values;

  Motions(const Program& integrator, const Case& c, const Rational& h)
      : program(integrator), force(force_named(c.force)), test(c) {
    for (const auto& [name, number] : {std::pair<const char*, Rational>{"k", c.k},
                                       {"c", c.c},
                                       {"k_force", c.k},  // so called beside a parameter k
                                       {"c_force", c.c},
                                       {"h", h},
                                       {"x0", Rational(7, 5)},
                                       {"v0", Rational(-3, 4)}})
      values[name] = decimal(number);
    for (int d = 0; d <= force.degree; ++d)
      values[force.degree == 0 ? "a" : "f" + std::to_string(d)] = decimal(c.push.at(d));
    for (const Definition& d : flow().definitions) values[d.name] = value(d.value, values);
  }

  /// The formulas of the true motion that hold for these numbers.
  FlowCase flow() const {
    LinearFlow all = linear_flow(force, letter_names(lower(program)));
    const Rational discriminant = test.k - test.c * test.c / 4;
    if (force.k || !force.spring || discriminant.sign() > 0) return all;
    return discriminant.is_zero() ? all.others.at(0) : all.others.back();
  }

  /// The derivative of the force polynomial.
  Real push(int derivative, const Real& t) const {
    Real total = decimal(Rational(0));
    for (int d = force.degree; d >= derivative; --d) {
      total = total * t;
      total = total + decimal(test.push.at(d) * factorial(d) / factorial(d - derivative));
    }
    return total;
  }

  /// Positions and velocities after 0..steps steps of the integrator, which is given k, c and the force as a
  /// combination gamma_j f^(j); `states` replaces carried vectors after the start.
  std::vector<std::pair<Real, Real>> stepped(const Real& k, const Real& c, const std::vector<Real>& gamma,
                                             const Real& x0, const Real& v0, int steps, int substeps = 1,
                                             const std::map<std::string, Real>& states = {}) const {
    Numbers<Real> problem;
    problem.force = [&](const Real& x, const Real& v, const Real& t) -> Real {
      Real result = decimal(Rational(0));
      for (int j = 0; j < static_cast<int>(gamma.size()); ++j) {
        const Real part = gamma[j] * push(j, t);
        result = result + part;
      }
      const Real kx = k * x, cv = c * v;
      result = result - kx;
      result = result - cv;
      return result;
    };
    problem.round = [](const Rational& r) { return decimal(r); };
    const Tape tape = lower(substepped(program, substeps));
    Run<Numbers<Real>> run(tape, problem, values.at("h"));
    run.begin(x0, v0, decimal(Rational(0)));
    for (std::size_t i = 0; i < tape.states.size(); ++i)
      if (const auto found = states.find(tape.states[i]); found != states.end())
        run.set_state(static_cast<int>(i), found->second);
    std::vector<std::pair<Real, Real>> result{run.read_out()};
    for (int n = 0; n < steps; ++n) {
      run.step();
      result.push_back(run.read_out());
    }
    return result;
  }

  Real zero_unless(bool there, const char* name) const {
    return there ? values.at(name) : decimal(Rational(0));
  }
};

inline bool close(const Real& a, const Real& b) {
  const Real scale = Real(abs(a)) + Real(abs(b)) + decimal(Rational(1));
  return Real(abs(Real(a - b))) < scale * decimal(Rational::parse("1e-80"));
}

/// The solution of a kit's equations by Newton's method from the true values, derivatives by differences:
/// k_new, c_new.
inline void solve_equations(const LinearKit& kit, Reals& values) {
  const ImplicitParameters& p = *kit.implicit;
  std::vector<std::string> names;
  for (const Letter unknown : p.unknowns) names.push_back(kit.letters.at(unknown));
  for (const std::string& name : names) values[name] = name == "k_new" ? values.at("k") : values.at("c");
  const auto at = [&](std::size_t i) {
    return value(formula(Fraction(p.equations[i]), kit.wording()), values);
  };
  const std::size_t n = names.size();
  for (int round = 0; round < 60; ++round) {
    std::vector<Real> f;
    for (std::size_t i = 0; i < n; ++i) f.push_back(at(i));
    std::vector<std::vector<Real>> slope(n, std::vector<Real>(n));
    for (std::size_t j = 0; j < n; ++j) {
      const Real kept = values[names[j]], width = decimal(Rational::parse("1e-45"));
      values[names[j]] = kept + width;
      for (std::size_t i = 0; i < n; ++i) slope[i][j] = Real(at(i) - f[i]) / width;
      values[names[j]] = kept;
    }
    if (n == 1) {
      values[names[0]] = values[names[0]] - f[0] / slope[0][0];
      continue;
    }
    const Real det = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    values[names[0]] = values[names[0]] - Real(f[0] * slope[1][1] - f[1] * slope[0][1]) / det;
    values[names[1]] = values[names[1]] - Real(f[1] * slope[0][0] - f[0] * slope[1][0]) / det;
  }
  for (std::size_t i = 0; i < n; ++i) CHECK(Real(abs(at(i))) < decimal(Rational::parse("1e-80")));
}

/// Steps the integrator with everything that the kit replaces and holds every frame against the true motion.
inline void check_every_frame(Motions& m, const LinearKit& kit, int steps, int substeps = 1) {
  using Kind = LinearCorrection::Kind;
  for (const ExtraLetters::Extra& e : kit.extras)
    if (e.root) m.values[e.name] = decimal(near(*e.root, 2 * kDigits));
  for (const Definition& d : kit.definitions)
    if (!m.values.contains(d.name)) m.values[d.name] = value(d.value, m.values);
  // C and S of the case that these numbers are in.
  if (m.force.spring) {
    const FlowCase flow = m.flow();
    for (const auto& [letter, e] : {std::pair{"C", flow.cosine}, {"S", flow.sine}})
      m.values[letter] = value(replace(e, "t", name("h")), m.values);
    for (const Definition& d : kit.definitions)
      if (d.name != "C" && d.name != "S" && d.name != "D" && !d.name.starts_with("w"))
        m.values[d.name] = value(d.value, m.values);
  }
  if (kit.implicit && kit.implicit->radicals.empty()) solve_equations(kit, m.values);
  for (const Definition& d : kit.step_definitions) m.values[d.name] = value(d.value, m.values);
  Real k = m.zero_unless(m.force.spring, "k");
  Real c = m.zero_unless(m.force.damper, "c");
  std::vector<Real> gamma;
  if (m.force.degree >= 0) gamma.push_back(decimal(Rational(1)));
  Real x0 = m.values.at("x0"), v0 = m.values.at("v0");
  std::map<std::string, Real> states;
  Expr read_out = name("v_n");
  const auto derivatives_at = [&](const Real& t) {
    for (int j = 0; j <= m.force.degree; ++j)
      m.values[m.force.degree == 0 ? "a" : "f" + std::string(j, '\'')] = m.push(j, t);
  };
  for (const LinearCorrection& correction : kit.corrections) {
    const std::string& target = correction.target;
    if (correction.kind == Kind::read_out) {
      read_out = correction.value;
      // Spelled out in t it is the same.
      const Real t = decimal(Rational(17, 4));
      derivatives_at(t);
      Reals spelled = m.values;
      spelled["t"] = t;
      spelled["x_n"] = m.values["x_n"] = decimal(Rational(2, 3));
      spelled["v_n"] = m.values["v_n"] = decimal(Rational(5, 7));
      CHECK(close(value(correction.value, m.values), value(correction.spelled, spelled)));
    } else if (correction.kind == Kind::launch) {
      derivatives_at(decimal(Rational(0)));
      const Real replaced = value(correction.value, m.values);
      CHECK(close(replaced, value(correction.spelled, m.values)));
      if (correction.reason.starts_with("begin with"))
        states[target] = replaced;
      else
        (target == "x0" ? x0 : v0) = replaced;
    } else if (target == "a" || target == "f") {
      // Linear in the derivatives: their factors one by one.
      gamma.clear();
      for (int j = 0; j <= m.force.degree; ++j) {
        for (int i = 0; i <= m.force.degree; ++i)
          m.values[m.force.degree == 0 ? "a" : "f" + std::string(i, '\'')] =
              decimal(Rational(i == j ? 1 : 0));
        gamma.push_back(value(correction.value, m.values));
      }
      derivatives_at(decimal(Rational(0)));
    } else {
      (target == "k" ? k : c) = value(correction.value, m.values);
    }
  }
  const auto frames = m.stepped(k, c, gamma, x0, v0, steps, substeps, states);
  const FlowCase flow = m.flow();
  for (const int n : {0, 1, 2, 3, 50, 200}) {
    if (n > steps) break;
    CAPTURE(n);
    m.values["t"] = decimal(Rational(n)) * m.values["h"];
    m.values["x_n"] = frames[n].first;
    m.values["v_n"] = frames[n].second;
    derivatives_at(m.values["t"]);
    Reals truth = m.values;  // there a, f0, ... are the letters
    for (int d = 0; d <= m.force.degree; ++d)
      truth[m.force.degree == 0 ? "a" : "f" + std::to_string(d)] = decimal(m.test.push.at(d));
    CHECK(close(frames[n].first, value(flow.position, truth)));
    CHECK(close(value(read_out, m.values), value(flow.velocity, truth)));
  }
}

}  // namespace shortfall::linear
