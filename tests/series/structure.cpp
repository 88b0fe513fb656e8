// SPDX-License-Identifier: GPL-3.0-or-later
// Energy and symplecticity by trees, against the step itself in exact arithmetic: a polynomial potential in
// the plane, as a power series in h.
#include <doctest/doctest.h>

#include <random>

#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/program/run.hpp"
#include "analysis/series/conjugation.hpp"
#include "analysis/series/invariants.hpp"
#include "tests/series/plane_force.hpp"

using namespace shortfall;
using testing::PlaneForce;

namespace {

constexpr int kPlaneOrder = 4;  // powers of h that are looked at in the plane

Polynomial letter(Letter l) { return Polynomial::letter(l); }

/// No term left out, so that no free tree vanishes.
Polynomial planar_potential() {
  const Polynomial x = letter(0), y = letter(1), s = x + Polynomial(Rational(2, 3)) * y;
  return Polynomial(Rational(1, 2)) * x * x + Polynomial(Rational(1, 3)) * x * y + y * y +
         Polynomial(Rational(1, 5)) * s * s * s + Polynomial(Rational(1, 7)) * x * x * y * y + x * y * y;
}

struct Plane {
  Polynomial v = planar_potential();
  PlaneForce force{{Polynomial(0) - v.derivative(0), Polynomial(0) - v.derivative(1)}, kPlaneOrder};

  /// x and v after a step of the length `h`, from where x and v are letters or what is given.
  std::array<Polynomial, 4> after(const SeriesSource& source, const Polynomial& h,
                                  const PlaneForce::Vector& x, const PlaneForce::Vector& u) {
    Run<PlaneForce> run(source.tape(), force, {h});
    run.begin(x, u, {Polynomial(0)});
    run.step();
    const PlaneForce::Vector p = force.truncated(run.state(0)), q = force.truncated(run.state(1));
    return {p.c[0], p.c[1], q.c[0], q.c[1]};
  }
  std::array<Polynomial, 4> after(const SeriesSource& source) {
    return after(source, letter(PlaneForce::kStep), PlaneForce::position(), PlaneForce::velocity());
  }
  Polynomial truncated(const Polynomial& p) const { return force.truncated({{p, Polynomial(0)}}).c[0]; }

  /// The energy after a step minus that before.
  Polynomial energy_gained(const std::array<Polynomial, 4>& z) {
    const Polynomial half(Rational(1, 2));
    Polynomial after = half * (z[2] * z[2] + z[3] * z[3]);
    for (const Polynomial::Term& term : v.terms()) {
      Polynomial product(term.coefficient);
      for (Letter l : {0, 1})
        for (int k = 0; k < term.monomial.exponent(l); ++k)
          product = truncated(product * z[static_cast<std::size_t>(l)]);
      after += product;
    }
    return truncated(after - half * (letter(2) * letter(2) + letter(3) * letter(3)) - v);
  }
  /// What J^T Omega J differs by from Omega, one entry after the other.
  std::vector<Polynomial> area_gained(const std::array<Polynomial, 4>& z) {
    std::vector<Polynomial> result;
    for (Letter i = 0; i < 4; ++i)
      for (Letter j = 0; j < i; ++j) {
        Polynomial sum(i == j + 2 ? 1 : 0);  // columns j and i: dx_j and dv_j
        for (std::size_t k : {0U, 1U})
          sum += z[k].derivative(i) * z[k + 2].derivative(j) - z[k].derivative(j) * z[k + 2].derivative(i);
        result.push_back(truncated(sum));
      }
    return result;
  }
};

/// The lowest power of h in a polynomial; one more than all that are looked at for none.
int lowest_power(const Polynomial& p) {
  int lowest = kPlaneOrder + 1;
  for (const Polynomial::Term& term : p.terms())
    lowest = std::min(lowest, term.monomial.exponent(PlaneForce::kStep));
  return lowest;
}

std::vector<Program> plain_programs() {
  std::vector<Program> result;
  for (const Program& program : catalogue()) {
    if (program.approximate() || !program.roots.empty()) continue;
    const SeriesSource source(program, {});
    if (source.rational() && source.tape().states.size() == 2 && source.tape().start.empty())
      result.push_back(program);
  }
  std::mt19937 generator(5);
  const auto fraction = [&] {
    return std::to_string(std::uniform_int_distribution<int>(-4, 4)(generator)) + "/" +
           std::to_string(std::uniform_int_distribution<int>(1, 3)(generator));
  };
  for (int k = 0; k < 9; ++k) {
    const std::string c = fraction(), d = fraction(), a = fraction();
    const std::string splitting =
        "splitting\n  drift " + c + "\n  kick " + d + "\n  drift 1 - (" + c + ")\n  kick 1 - (" + d + ")\n";
    const std::string palindrome = "splitting\n  drift " + c + "\n  kick 1/2\n  drift 1 - 2*(" + c +
                                   ")\n  kick 1/2\n  drift " + c + "\n";
    const std::string tableau = "tableau\n  0 |\n  " + a + " | " + a + "\n  b | " + c + " (1-(" + c + "))\n";
    result.push_back(parse("integrator random\n  source nobody\n\n" + (k % 3 == 0   ? splitting
                                                                       : k % 3 == 1 ? palindrome
                                                                                    : tableau),
                           "random"));
  }
  return result;
}

}  // namespace

TEST_CASE("the energy changes in a step with the power of h that the trees say, in the plane") {
  int changed = 0;
  for (const Program& program : plain_programs()) {
    CAPTURE(program.name);
    Plane plane;
    const SeriesSource source(program, {});
    const EnergyChange found = energy_change(source, kPlaneOrder);
    const int seen = lowest_power(plane.energy_gained(plane.after(source)));
    CHECK(seen == (found.order > 0 ? found.order : kPlaneOrder + 1));
    changed += found.order > 0;
  }
  CHECK(changed >= 25);
}

TEST_CASE("energy changes that are known: explicit Euler's, and velocity Verlet's from its modified energy") {
  const auto term = [](const char* name, const std::string& contraction) {
    for (const EnergyChange::Term& t : energy_change(SeriesSource(find_integrator(name), {}), 6).terms)
      if (t.contraction == contraction) return t.coefficient;
    return Fraction(0);
  };
  // H(x + h v, v - h V') - H = h^2/2 (V''(v, v) + V' V') + ...
  CHECK(term("explicit-euler", "V''(v, v)") == Fraction(Rational(1, 2)));
  CHECK(term("explicit-euler", "V' V'") == Fraction(Rational(1, 2)));
  // -h times the derivative of h^2 (v^2 V''/12 - V'^2/24).
  CHECK(term("velocity-verlet", "V'''(v, v, v)") == Fraction(Rational(-1, 12)));
  CHECK(term("velocity-verlet", "V''(v, V')") == Fraction(Rational(1, 4)));
}

TEST_CASE("what is called symplectic keeps areas in the plane, and nothing else does") {
  int kept = 0, lost = 0;
  for (const Program& program : plain_programs()) {
    CAPTURE(program.name);
    Plane plane;
    const SeriesSource source(program, {});
    const Property found = structure(source).symplectic;
    int seen = kPlaneOrder + 1;
    for (const Polynomial& p : plane.area_gained(plane.after(source))) seen = std::min(seen, lowest_power(p));
    if (found.holds())
      CHECK(seen == kPlaneOrder + 1);
    else
      CHECK(seen == std::min(found.up_to, kPlaneOrder + 1));
    (found.holds() ? kept : lost) += 1;
  }
  CHECK(kept >= 8);
  CHECK(lost >= 8);
}

TEST_CASE("what is called symmetric is undone by a step with -h in the plane, and nothing else is") {
  int symmetric = 0, not_symmetric = 0;
  for (const Program& program : plain_programs()) {
    CAPTURE(program.name);
    Plane plane;
    const SeriesSource source(program, {});
    const auto z = plane.after(source);
    const Polynomial back = Polynomial(0) - letter(PlaneForce::kStep);
    const auto again = plane.after(source, back, {{z[0], z[1]}}, {{z[2], z[3]}});
    int seen = kPlaneOrder + 1;
    for (Letter l = 0; l < 4; ++l)
      seen = std::min(seen, lowest_power(again[static_cast<std::size_t>(l)] - letter(l)));
    const Property found = structure(source).symmetric;
    // Refuted later than seen here: not at all in these powers.
    if (found.holds() || found.up_to > kPlaneOrder)
      CHECK(seen == kPlaneOrder + 1);
    else
      CHECK(seen <= kPlaneOrder);
    (found.holds() ? symmetric : not_symmetric) += 1;
  }
  CHECK(symmetric >= 6);
  CHECK(not_symmetric >= 8);
}

TEST_CASE(
    "a symplectic field behind a random change of variables is found to be conjugate to one, a random field "
    "is not") {
  const SeriesSource verlet(find_integrator("velocity-verlet"), {});
  const TreeTable table(Signature::mechanical(false, false), 6);
  std::mt19937 generator(3);
  for (int repeat = 0; repeat < 5; ++repeat) {
    TreeSeries<Rational> change(table.size(), Rational(0));
    for (TreeId t = 0; t < table.size(); ++t)
      change[t] = Rational(std::uniform_int_distribution<int>(-3, 3)(generator), 2);
    TreeSeries<Rational> field = conjugated(table, change, verlet.step<Rational>(table).field);
    const Property hidden = conjugate_symplectic<Rational>(verlet, table, field);
    CHECK(hidden.holds());
    CHECK(hidden.up_to == 6);
    for (TreeId t = table.begin(3); t < table.size(); ++t)
      field[t] += Rational(std::uniform_int_distribution<int>(1, 5)(generator), 3);
    CHECK(!conjugate_symplectic<Rational>(verlet, table, field).holds());
  }
}
