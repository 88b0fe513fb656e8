// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/kit_numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "tests/undamped_catalogue.hpp"

#include "tests/correction/linear_motions.hpp"

using namespace shortfall;
using namespace shortfall::linear;

namespace {

Rational number_of(const KitNumbers& numbers, const std::string& target, const std::string& vector) {
  for (const NumericCorrection& c : numbers.corrections)
    if (c.target == target)
      for (const auto& [number, name] : c.terms)
        if (name == vector) {
          REQUIRE(number.decimal);
          return Rational::parse(*number.decimal);
        }
  return 0;
}

}  // namespace

TEST_CASE("numbers typed into the integrator make every frame exact to their digits" *
          doctest::test_suite("thorough")) {
  const Precision precision(kDigits);
  int checked = 0;
  for (const Program& p : testing::short_catalogue())
    for (const Case& test : std::vector<Case>{{"spring:k=3", 3, 0, {}},
                                              {"damped-spring:k=4,c=4", 4, 4, {}},
                                              {"constant+damped-spring:k=5,c=1/3", 5, Rational(1, 3), {2}},
                                              {"drag:c=2/3", 0, Rational(2, 3), {Rational(-981, 100)}}}) {
      CAPTURE(p.name);
      CAPTURE(test.force);
      Motions m(p, test, Rational(1, 10));
      const Values parameters = parameter_values(p);
      const LinearKit kit = linear_kit(p, m.force, parameters);
      REQUIRE(kit.exists);
      const KitNumbers n = kit_numbers(kit, m.force, parameters, Rational(1, 10), 40);
      CHECK(n.solved == (kit.implicit && kit.implicit->radicals.empty()));
      const auto combined = [&](const std::string& target, const char* x, const char* v, const Rational& a) {
        return Real(decimal(number_of(n, target, x)) * m.values.at("x0")) +
               Real(decimal(number_of(n, target, v)) * m.values.at("v0")) +
               decimal(number_of(n, target, "a") * a);
      };
      const Rational a = test.push.empty() ? Rational(0) : test.push[0];
      Real x0 = m.values.at("x0"), v0 = m.values.at("v0");
      Real k = m.zero_unless(m.force.spring, "k"), c = m.zero_unless(m.force.damper, "c");
      std::map<std::string, Real> states;
      for (const LinearCorrection& correction : kit.corrections) {
        if (correction.kind == LinearCorrection::Kind::launch) {
          const Real launch = combined(correction.target, "x0", "v0", a);
          if (correction.reason.starts_with("begin with"))
            states[correction.target] = launch;
          else
            (correction.target == "x0" ? x0 : v0) = launch;
        }
        if (correction.target == "k") k = decimal(number_of(n, "k", ""));
        if (correction.target == "c") c = decimal(number_of(n, "c", ""));
      }
      std::vector<Real> gamma;
      if (m.force.degree == 0) gamma.push_back(decimal(number_of(n, "a", "a")));
      const auto frames = m.stepped(k, c, gamma, x0, v0, 60, 1, states);
      const FlowCase flow = m.flow();
      for (const int at : {1, 7, 60}) {
        m.values["t"] = decimal(Rational(at, 10));
        CHECK(Real(abs(Real(frames[at].first - value(flow.position, m.values)))) <
              decimal(Rational::parse("1e-34")));
      }
      ++checked;
    }
  CHECK(checked > 80);
}

TEST_CASE("where a kit ends it says so, and a letter without a number is asked for") {
  const Program rk4 = find_integrator("rk4");
  const Force drag = force_named("drag:c=4");
  const LinearKit kit = linear_kit(rk4, drag);
  CHECK_NOTHROW(kit_numbers(kit, drag, {}, Rational(13, 40)));  // c h = 1.3 < 1.3078
  CHECK_THROWS_WITH_AS(kit_numbers(kit, drag, {}, Rational(1, 2)), doctest::Contains("0.270395"), Unable);
  const Force open = force_named("spring");
  CHECK_THROWS_AS(kit_numbers(linear_kit(rk4, open), open, {}, Rational(1, 2)), BadInput);
}
