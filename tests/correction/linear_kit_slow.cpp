// SPDX-License-Identifier: GPL-3.0-or-later
// The whole catalogue, 200 steps at 100 digits.
#include "analysis/correction/linear_kit.hpp"
#include "analysis/program/catalogue.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "tests/correction/linear_motions.hpp"
#include "tests/undamped_catalogue.hpp"

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

/// The catalogue without engines, whose damping has the name of the force's.
std::vector<Program> methods() {
  std::vector<Program> all;
  for (const Program& p : testing::short_catalogue())
    if (family(p) != "engines") all.push_back(p);
  return all;
}

/// Ten and more stages: seconds for each force. Their kits for a spring are checked.
bool is_long(const Program& p, const Case& test) {
  return p.name.starts_with("blanes-moan") && test.force != "spring" && test.force != "drag";
}

}  // namespace

TEST_CASE("the closed forms with cos and sin agree with stepping over 200 steps at 100 digits") {
  const Precision precision(kDigits);
  int compared = 0;
  for (const Program& p : methods())
    for (const Case& test : kCases) {
      CAPTURE(p.name);
      CAPTURE(test.force);
      Motions m(p, test, Rational(1, 20));
      if (is_long(p, test)) continue;
      LinearDerivation d;
      try {
        d = linear_derivation(m.program, m.force, parameter_values(m.program));
      } catch (const Unable& e) {
        CHECK(std::string(e.what()).find("terms") != std::string::npos);  // too long to be read
        continue;
      }
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
      std::vector<Real> gamma;
      if (m.force.degree >= 0) gamma.push_back(decimal(Rational(1)));
      const auto states = m.stepped(m.zero_unless(m.force.spring, "k"), m.zero_unless(m.force.damper, "c"),
                                    gamma, m.values.at("x0"), m.values.at("v0"), 200);
      for (const int n : {2, 3, 17, 200}) {
        m.values["n"] = real(Rational(n), kDigits);
        m.values["t"] = m.values["n"] * m.values["h"];
        if (oscillates) {
          CHECK(close(value(d.position, m.values), states[n].first));
          CHECK(close(value(d.velocity, m.values), states[n].second));
        } else {
          CHECK(close(value(d.cases[1].position, m.values), states[n].first));
          CHECK(close(value(d.cases[1].velocity, m.values), states[n].second));
        }
        ++compared;
      }
    }
  CHECK(compared > 500);
}

TEST_CASE(
    "the kit of every integrator makes every frame exact: stepped at 100 digits against the true motion") {
  const Precision precision(kDigits);
  int repaired = 0;
  for (const Program& p : methods())
    for (const Case& test : kCases)
      for (const int substeps : {1, 2}) {
        if (substeps > 1 && family(p) != "euler") continue;
        CAPTURE(p.name);
        CAPTURE(test.force);
        Motions m(p, test, Rational(1, 20));
        if (is_long(p, test)) continue;
        LinearKit kit;
        try {
          kit = linear_kit(m.program, m.force, parameter_values(m.program), substeps);
        } catch (const Unable& e) {
          CHECK(std::string(e.what()).find("terms") != std::string::npos);
          continue;
        }
        CAPTURE(kit.obstruction);
        CHECK((kit.exists || kit.obstruction.find("are not written out") != std::string::npos));
        if (!kit.exists) continue;
        ++repaired;
        check_every_frame(m, kit, 200, substeps);
      }
  CHECK(repaired > 200);
}
