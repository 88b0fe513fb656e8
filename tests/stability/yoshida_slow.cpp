// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients in a field of degree fifteen, and a limit that is a number of degree 120.
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/problems/letters.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/stability/oscillator_step.hpp"

using namespace shortfall;
using testing::triple_jump, testing::verlet;

namespace {

double trace_in_binary64(double z) {
  const double w = 1 / (2 - std::cbrt(2.0)), u = 1 / (2 - std::pow(2.0, 0.2));
  double m[2][2] = {{1, 0}, {0, 1}};
  for (const double outer : {u, 1 - 2 * u, u})
    for (const double inner : {w, 1 - 2 * w, w})
      for (int column = 0; column < 2; ++column) {
        const double h = outer * inner;
        m[0][column] += h / 2 * m[1][column];
        m[1][column] -= h * z * z * m[0][column];
        m[0][column] += h / 2 * m[1][column];
      }
  return m[0][0] + m[1][1];
}

}  // namespace

TEST_CASE("a cube root and a fifth root at once: the triple jump of the triple jump, order six") {
  // source: Yoshida (1990), Construction of higher order symplectic integrators, Physics Letters A 150,
  // (3.9)-(3.13)
  constexpr Letter kW = kFirstParameter, kU = kFirstParameter + 1;
  const SquareMatrix<Fraction> m = triple_jump(1, Fraction::letter(kU), [](const Fraction& h) {
    return triple_jump(h, Fraction::letter(kW), [](const Fraction& c) { return verlet(c); });
  });
  const AlgebraicLetter w{kW, RealRoot(Univariate<Rational>({-2, 0, 0, 1}), 1, 2)};
  const AlgebraicLetter u{kU, RealRoot(Univariate<Rational>({-2, 0, 0, 0, 0, 1}), 1, 2)};
  const Amplification a = amplification(m, {"n", "h", "t", "k", "c", "w", "u"}, {"x", "v"}, {w, u});
  CHECK(a.determinant() == Fraction(1));
  const auto limit = stability_limit(oscillator_windows(a));
  REQUIRE(limit);
  CHECK(limit->degree() == 120);
  const double at = limit->to_double();
  for (double z = 0.001; z < at * (1 - 1e-9); z += 0.001) REQUIRE(std::abs(trace_in_binary64(z)) < 2);
  CHECK(std::abs(trace_in_binary64(at * (1 - 1e-9))) < 2);
  CHECK(std::abs(trace_in_binary64(at * (1 + 1e-9))) > 2);
}
