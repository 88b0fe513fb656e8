// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/kit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/print.hpp"
#include "analysis/program/run.hpp"
#include "analysis/program/transform.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;
using Op = Expression::Op;

namespace {

Rational value(const Expr& e, const Values& values) {
  const auto& o = e->operands;
  switch (e->op) {
    case Op::number:
      return e->value;
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
    case Op::power: {
      std::int64_t exponent = 0;
      REQUIRE(value(o[1], values).fits_int64(exponent));
      return value(o[0], values).pow(static_cast<int>(exponent));
    }
    default:
      FAIL("unexpected");
      return 0;
  }
}

/// Applies an option to the integrator itself, in rational numbers: launch once, force and term in every
/// step, read-out at the end. Nothing of the closed forms is used.
bool repairs(const Program& program, int degree, int substeps, const CorrectionOption& option) {
  std::mt19937 random(7);
  const auto draw = [&] {
    return Rational(static_cast<int>(random() % 41) - 20, 1 + static_cast<int>(random() % 7));
  };
  Values values = parameter_values(program);
  std::vector<Rational> f;
  for (int d = 0; d <= degree; ++d) {
    f.push_back(draw());
    values[degree == 0 ? "a" : "f" + std::to_string(d)] = f.back();
  }
  const Rational h(1, 5);
  const Rational x0 = draw();
  const Rational v0 = draw();
  values["h"] = h;
  values["v0"] = v0;
  const auto added = [&](Correction::Kind kind, const std::string& target, const Rational& t,
                         const Rational& v = 0) {
    Rational total;
    Values at = values;
    at["t"] = t;
    at["v"] = v;
    for (const Correction& c : option.corrections)
      if (c.kind == kind && c.target == target) total += value(c.add, at);
    return total;
  };
  const std::string force_name = degree == 0 ? "a" : "f";
  Numbers<Rational> problem{[&](const Rational&, const Rational&, const Rational& t) {
    Rational total;
    for (int d = degree; d >= 0; --d) total = total * t + f[d];
    return total + added(Correction::Kind::force, force_name, t);
  }};
  const Tape tape = lower(substepped(program, substeps));
  Run<Numbers<Rational>> run(tape, problem, h);
  run.begin(x0 + added(Correction::Kind::launch, "x0", 0), v0 + added(Correction::Kind::launch, "v0", 0), 0);
  for (int n = 0; n <= 9; ++n) {
    const Rational t = h * n;
    if (n >= 3) {  // a start that is still felt is told separately
      auto [x, v] = run.read_out();
      v += added(Correction::Kind::read_out, "v", t);
      x += added(Correction::Kind::read_out, "x", t, v);
      Rational exact_x = x0 + v0 * t;
      Rational exact_v = v0;
      for (int d = 0; d <= degree; ++d) {
        exact_v += f[d] * t.pow(d + 1) / Rational(d + 1);
        exact_x += f[d] * t.pow(d + 2) / Rational((d + 1) * (d + 2));
      }
      if (x != exact_x || v != exact_v) return false;
    }
    const Rational term_x = added(Correction::Kind::term, "x", t);
    const Rational term_v = added(Correction::Kind::term, "v", t);
    run.step();
    run.set_state(0, run.state(0) + term_x);
    run.set_state(1, run.state(1) + term_v);
  }
  return true;
}

const CorrectionOption& named(const CorrectionKit& kit, std::string_view name) {
  const auto found = std::ranges::find(kit.options, name, &CorrectionOption::name);
  REQUIRE(found != kit.options.end());
  return *found;
}

std::string added_to(const CorrectionOption& option, Correction::Kind kind, const std::string& target) {
  for (const Correction& c : option.corrections)
    if (c.kind == kind && c.target == target) return print(c.add);
  return "";
}

CorrectionKit kit_of(const std::string& integrator, int degree) {
  return correction_kit(derivation(find_integrator(integrator), degree, {}, 1, false));
}

}  // namespace

TEST_CASE(
    "the origin story's fix: add -a h/2 to the launch, that is g h/2, and take it off the velocity read "
    "out") {
  const CorrectionKit kit = kit_of("symplectic-euler", 0);
  const CorrectionOption& launch = named(kit, "launch");
  CHECK(launch.exists);
  CHECK(added_to(launch, Correction::Kind::launch, "v0") == "-1/2*a*h");
  CHECK(added_to(launch, Correction::Kind::read_out, "v") == "1/2*a*h");
  CHECK_FALSE(named(kit, "force alone").exists);
  CHECK(added_to(named(kit, "term"), Correction::Kind::term, "x") == "-1/2*a*h^2");
}

TEST_CASE("for any polynomial force, kick-drift needs the force and launch series of Euler and Maclaurin") {
  const int degree = 9;
  const Derivation d = derivation(find_integrator("symplectic-euler"), degree, {}, 1, false);
  const CorrectionKit kit = correction_kit(d);
  const CorrectionOption& option = named(kit, "force and launch");
  REQUIRE(option.exists);
  // f~ - f = sum over k >= 1 of 2 h^{2k}/(2k+2)! f^{(2k)};  v0' - v0 = sum over k of (-1)^{k+1}
  // h^{k+1}/(k+2)! f^{(k)}(0)
  Values values{{"h", Rational(2, 7)}, {"t", Rational(3, 5)}};
  std::vector<Rational> f;
  for (int i = 0; i <= degree; ++i) {
    f.push_back(Rational(i * i - 7, i + 2));
    values["f" + std::to_string(i)] = f.back();
  }
  const auto derivative = [&](int k, const Rational& t) {
    Rational total;
    for (int i = k; i <= degree; ++i) total += f[i] * factorial(i) / factorial(i - k) * t.pow(i - k);
    return total;
  };
  Rational force;
  Rational launch;
  Rational read_out;
  const Rational h = values["h"];
  for (int k = 0; k <= degree; ++k) {
    if (k >= 1 && 2 * k <= degree)
      force += Rational(2) * h.pow(2 * k) / factorial(2 * k + 2) * derivative(2 * k, values["t"]);
    const Rational weight = Rational(k % 2 == 0 ? -1 : 1) * h.pow(k + 1) / factorial(k + 2);
    launch += weight * derivative(k, 0);
    read_out -= weight * derivative(k, values["t"]);
  }
  for (const Correction& c : option.corrections) {
    CAPTURE(c.series);
    const Rational found = value(c.add, values);
    if (c.kind == Correction::Kind::force) CHECK(found == force);
    if (c.kind == Correction::Kind::launch) CHECK(found == launch);
    if (c.kind == Correction::Kind::read_out) CHECK(found == read_out);
  }
  CHECK(option.corrections.size() == 3);
}

TEST_CASE("every option that exists repairs the stepped integrator itself" *
          doctest::test_suite("thorough")) {
  int tried = 0;
  for (const Program& p : testing::short_catalogue())
    for (const auto& [highest, substeps] : {std::pair{0, 1}, {1, 1}, {2, 3}, {4, 1}}) {
      const int degree = highest;
      CAPTURE(p.name);
      CAPTURE(degree);
      const Derivation d = derivation(p, degree, {}, substeps, false);
      const CorrectionKit kit = correction_kit(d);
      for (const CorrectionOption& o : kit.options) {
        CAPTURE(o.name);
        if (!o.exists) {
          CHECK_FALSE(o.obstruction.empty());
          continue;
        }
        ++tried;
        CHECK(repairs(p, degree, substeps, o));
      }
    }
  CHECK(tried > 100);
}

TEST_CASE("a correction with one coefficient changed repairs nothing") {
  const Program p = find_integrator("symplectic-euler");
  const CorrectionKit kit = kit_of("symplectic-euler", 2);
  CorrectionOption option = *kit.best();
  REQUIRE(repairs(p, 2, 1, option));
  option.corrections.front().add = option.corrections.front().add * number(Rational(999, 1000));
  CHECK_FALSE(repairs(p, 2, 1, option));
}

TEST_CASE("explicit Euler under a force that grows: no launch cancels an error that grows like t^2") {
  const CorrectionKit kit = kit_of("explicit-euler", 1);
  const CorrectionOption& launch = named(kit, "launch");
  CHECK_FALSE(launch.exists);
  CHECK(launch.obstruction == "no such correction cancels the position term 1/2*f1*h*t^2 of the shortfall");
  CHECK_FALSE(named(kit, "launch and read-out").exists);
  // ... but starting one step behind does
  const CorrectionOption& shifted = named(kit, "launch and read-out with a shift in time");
  CHECK(shifted.exists);
  CHECK(added_to(shifted, Correction::Kind::launch, "x0") == "-v0*h");
}

TEST_CASE("an exact method needs nothing") {
  CHECK_FALSE(kit_of("rk4", 2).needed);
  CHECK(kit_of("rk4", 3).needed);
}

TEST_CASE("decimals that do not quite add up are told from a step that is not consistent") {
  const auto obstruction = [](const std::string& weight) {
    const Program program = parse("integrator thirds\n  approx third = " + weight +
                                      "\nstep\n  v = v + h*a(x, v, t)\n  x = x + 3*third*h*v\n",
                                  "thirds");
    return named(correction_kit(derivation(program, 0, {}, 1, false)), "launch").obstruction;
  };
  CHECK(obstruction("0.33333333")
            .starts_with(
                "the coefficients as they are printed move even a free body wrongly, its position by no more "
                "than their last digits"));
  CHECK(
      obstruction("0.33333433").starts_with("the step is not consistent: even without a force the position"));
}

TEST_CASE("an inconsistent step is named as such") {
  const Program lame = parse("integrator lame\nstep\n  v = v + h*a(x, v, t)\n  x = x + 0.9*h*v\n", "lame");
  const CorrectionKit kit = correction_kit(derivation(lame, 0, {}, 1, false));
  CHECK_FALSE(named(kit, "launch").exists);
  CHECK(
      named(kit, "launch")
          .obstruction.starts_with("the step is not consistent: even without a force the position is wrong"));
  CHECK_THROWS_AS(correction_kit(derivation(lame, 31, {}, 1, false)), Unable);
}
