// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/hamiltonian.hpp"

#include <doctest/doctest.h>

#include <map>

#include "analysis/algebra/real.hpp"
#include "analysis/problems/numbers.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/run.hpp"

using namespace shortfall;

namespace {

constexpr int kEnergyDigits = 80;

std::string terms(const std::string& integrator, int power) {
  std::string text;
  for (const EnergyTerm& t : modified_hamiltonian(SeriesSource(find_integrator(integrator), {}), 4).terms)
    if (t.power == power)
      text += (text.empty() ? "" : "; ") + t.coefficient.constant().str() + " " + t.contraction;
  return text;
}

Real rounded(const Rational& r) { return real(r, kEnergyDigits); }

/// The derivatives of V = x^2/2 + x^3/3 - x^4/5 at x.
std::vector<Real> potential(const Real& x) {
  const Real one = rounded(1);
  return {x * x / 2 + x * x * x / 3 - x * x * x * x / 5,
          x + x * x - 4 * x * x * x / 5,
          one + 2 * x - 12 * x * x / 5,
          2 * one - 24 * x / 5,
          -24 * one / 5,
          0 * one,
          0 * one};
}

Real energy(const ModifiedHamiltonian& h, const SeriesSource& source, const Real& step, const Real& x,
            const Real& v) {
  const std::vector<Real> derivatives = potential(x);
  Real total = v * v / 2 + derivatives[0];
  for (const EnergyTerm& t : h.terms) {
    Real product = rounded(Rational::parse(source.decimal(t.coefficient, 50)));
    for (int k = 0; k < t.power; ++k) product *= step;
    for (std::size_t i = 0; i < t.in_one_dimension.size(); ++i)
      for (int k = 0; k < t.in_one_dimension[i]; ++k)
        product *= i == 0 ? v : i < derivatives.size() ? derivatives[i] : rounded(0);
    total += product;
  }
  return total;
}

/// What one step changes the energy by.
Real drift(const std::string& integrator, int order, const Rational& h) {
  const SeriesSource source(find_integrator(integrator), {});
  const ModifiedHamiltonian hamiltonian = modified_hamiltonian(source, order);
  REQUIRE(hamiltonian.exists());
  Numbers<Real> problem;
  problem.round = rounded;
  problem.force = [](const Real& x, const Real&, const Real&) { return Real(-potential(x)[1]); };
  Run<Numbers<Real>> run(source.tape(), problem, rounded(h));
  run.begin(rounded(Rational(1, 3)), rounded(Rational(2, 5)), rounded(0));
  run.step();  // away from what the start does
  const auto [x0, v0] = run.read_out();
  run.step();
  const auto [x1, v1] = run.read_out();
  return abs(Real(energy(hamiltonian, source, rounded(h), x1, v1) -
                  energy(hamiltonian, source, rounded(h), x0, v0)));
}

}  // namespace

TEST_CASE("modified Hamiltonians as printed in the literature") {
  // Hairer, Lubich & Wanner (2006), IX.3; Yoshida (1993).
  CHECK(terms("symplectic-euler", 1) == "-1/2 V' v");
  CHECK(terms("symplectic-euler", 2) == "1/12 V' V'; 1/12 V''(v, v)");
  CHECK(terms("symplectic-euler", 3) == "-1/12 V''(v, V')");
  CHECK(terms("symplectic-euler-drift-kick", 1) == "1/2 V' v");
  CHECK(terms("symplectic-euler-drift-kick", 3) == "1/12 V''(v, V')");
  CHECK(terms("velocity-verlet", 2) == "-1/24 V' V'; 1/12 V''(v, v)");
  CHECK(terms("position-verlet", 2) == "1/12 V' V'; -1/24 V''(v, v)");
  CHECK(terms("velocity-verlet", 1) == "");
  CHECK(terms("velocity-verlet", 3) == "");
}

TEST_CASE("methods known by their digits have no terms that are zero as far as the digits tell") {
  CHECK(modified_hamiltonian(SeriesSource(find_integrator("pefrl"), {}), 4).terms.empty());
  CHECK(modified_hamiltonian(SeriesSource(find_integrator("pefrl"), {}), 5).terms.size() == 4);
}

TEST_CASE("a step changes the modified energy by h^(order + 1) only, at 80 digits") {
  const Precision precision(kEnergyDigits);
  for (const char* name : {"symplectic-euler", "symplectic-euler-drift-kick", "velocity-verlet",
                           "position-verlet", "implicit-midpoint", "stoermer-verlet", "ruth3", "forest-ruth"})
    for (int order : {3, 4, 6}) {
      CAPTURE(name);
      CAPTURE(order);
      const Real coarse = drift(name, order, Rational(1, 1000)), fine = drift(name, order, Rational(1, 2000));
      const double seen = static_cast<double>(Real(log(Real(coarse / fine)) / log(rounded(2))));
      CHECK(seen > order + 0.9);
    }
}

TEST_CASE(
    "methods that conserve no energy have no modified Hamiltonian, and the trees that say so are named") {
  for (const char* name : {"explicit-euler", "rk4", "beeman", "newmark"}) {
    CAPTURE(name);
    const ModifiedHamiltonian h = modified_hamiltonian(SeriesSource(find_integrator(name), {}), 6);
    CHECK(!h.exists());
    CHECK(h.obstruction.find("are one free tree") != std::string::npos);
  }
  CHECK(modified_hamiltonian(SeriesSource(find_integrator("explicit-euler"), {}), 4).obstructed_at == 1);
  CHECK(modified_hamiltonian(SeriesSource(find_integrator("rk4"), {}), 6).obstructed_at == 4);
}
