// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/stability/stability.hpp"
#include "analysis/stability/windows_over.hpp"
#include "tests/stability/oscillator_step.hpp"
#include "tests/undamped_catalogue.hpp"

using namespace shortfall;
using testing::drift, testing::kick, testing::triple_jump, testing::verlet;

namespace {

constexpr Letter kW = kFirstParameter;      // an algebraic number
constexpr Letter kU = kFirstParameter + 1;  // another one

AlgebraicLetter root(Letter letter, int degree, int of) {
  std::vector<Rational> p(static_cast<std::size_t>(degree) + 1);
  p.front() = -of;
  p.back() = 1;
  return {letter, RealRoot(Univariate<Rational>(p), 1, of)};
}

using Matrix = SquareMatrix<Fraction>;

Amplification forest_ruth() {
  const Matrix m = triple_jump(1, Fraction::letter(kW), [](const Fraction& c) { return verlet(c); });
  return amplification(m, {"n", "h", "t", "k", "c", "w"}, {"x", "v"}, {root(kW, 3, 2)});
}

/// Where |trace| first leaves 2 in binary64: the same limit by other means.
double bisected_limit(double (*trace)(double), double low, double high) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (std::abs(trace(middle)) <= 2 ? low : high) = middle;
  }
  return low;
}

double forest_ruth_trace(double z) {
  double m[2][2] = {{1, 0}, {0, 1}};
  const double w = std::cbrt(2.0), c = 1 / (2 - w);
  for (const double h : {c, 1 - 2 * c, c})
    for (int column = 0; column < 2; ++column) {
      double& x = m[0][column];
      double& v = m[1][column];
      x += h / 2 * v;
      v -= h * z * z * x;
      x += h / 2 * v;
    }
  return m[0][0] + m[1][1];
}

}  // namespace

TEST_CASE("Forest and Ruth's limit is an exact algebraic number, 1.573401947434540...") {
  const Amplification a = forest_ruth();
  CHECK(a.determinant() == Fraction(1));
  CHECK_FALSE(a.trace().denominator().contains(kW));
  const Windows windows = oscillator_windows(a);
  const auto limit = stability_limit(windows);
  REQUIRE(limit);
  CHECK(limit->decimal(15) == "1.573401947434540");
  CHECK(limit->to_double() == doctest::Approx(bisected_limit(forest_ruth_trace, 1, 1.7)).epsilon(1e-14));
  // It is a root of its polynomial, the only one in its interval.
  CHECK(limit->polynomial().at(limit->low()).sign() * limit->polynomial().at(limit->high()).sign() == -1);
  CHECK(limit->degree() == 6);
  CHECK(limit->rational_square() == std::nullopt);
  REQUIRE(windows.limit());
  CHECK_FALSE(windows.limit()->pole);
  CHECK(windows.limit()->growth.kind == PowerGrowth::Kind::polynomial);
  CHECK(windows.windows[0].keeps);
}

TEST_CASE("windows of Forest and Ruth's method agree with the trace in binary64 everywhere") {
  const Windows windows = oscillator_windows(forest_ruth());
  const auto inside = [&](double z) {
    for (const Window& w : windows.windows)
      if ((!w.from || w.from->at.to_double() < z) && (!w.to || z < w.to->at.to_double())) return true;
    return false;
  };
  for (double z = 0.0105; z < 6; z += 0.01) {
    CAPTURE(z);
    CHECK(inside(z) == (std::abs(forest_ruth_trace(z)) < 2));
  }
}

TEST_CASE("an algebraic number that is rational after all changes nothing" *
          doctest::test_suite("thorough")) {
  // A letter for 1, and one for sqrt(2) that cancels in the end: w^2 stands for 2.
  for (const Program& p : testing::undamped_catalogue()) {
    CAPTURE(p.name);
    const Amplification plain = amplification(p, parameter_values(p));
    if (!plain.algebraic.empty()) continue;  // these have numbers of their own
    const Windows expected = bounded_windows(plain.matrix, kStiffness);
    Matrix scaled = plain.matrix;
    const Fraction w = Fraction::letter(kW);
    // Similar to the plain matrix: the first carried vector is measured in units of sqrt(2).
    for (std::size_t i = 1; i < scaled.size(); ++i) {
      scaled[0][i] = scaled[0][i] / w;
      scaled[i][0] = scaled[i][0] * w;
    }
    const Windows found = bounded_windows_over(scaled, kStiffness, {root(kW, 2, 2)});
    REQUIRE(found.windows.size() == expected.windows.size());
    for (std::size_t i = 0; i < found.windows.size(); ++i) {
      const Window &f = found.windows[i], &e = expected.windows[i];
      REQUIRE(f.from.has_value() == e.from.has_value());
      REQUIRE(f.to.has_value() == e.to.has_value());
      CHECK(f.from_included == e.from_included);
      CHECK(f.to_included == e.to_included);
      CHECK(f.decays == e.decays);
      CHECK(f.keeps == e.keeps);
      if (f.from) CHECK(f.from->at == e.from->at);
      if (f.to) {
        CHECK(f.to->at == e.to->at);
        CHECK(f.to->pole == e.to->pole);
        CHECK(f.to->growth.kind == e.to->growth.kind);
        CHECK(f.to->growth.degree == e.to->growth.degree);
      }
    }
  }
}

TEST_CASE("an irrational step: Verlet's limit in units of the cube root of 2") {
  // h is w times as long: stable for z w < 2.
  const Fraction w = Fraction::letter(kW);
  const Amplification a =
      amplification(verlet(w), {"n", "h", "t", "k", "c", "w"}, {"x", "v"}, {root(kW, 3, 2)});
  const auto limit = stability_limit(oscillator_windows(a));
  REQUIRE(limit);
  CHECK(*limit == RealRoot(Univariate<Rational>({-4, 0, 0, 1}), 1, 2));  // 2/2^(1/3) = 4^(1/3)
  // Drift-kick-drift at its limit: x_n = (-1)^n x0, while v grows linearly.
  CHECK(oscillator_windows(a).limit()->growth.kind == PowerGrowth::Kind::polynomial);
  CHECK(oscillator_windows(a).limit()->growth.degree == 1);
}

TEST_CASE("drag with an algebraic factor: its limit and where the velocity turns round") {
  // v1 = (1 - sqrt(2) d) v
  const Fraction w = Fraction::letter(kW), d = Fraction::letter(kDamping);
  const Amplification a = amplification({{1, 1 - w * d}, {0, 1 - w * d}}, {"n", "h", "t", "k", "c", "w"},
                                        {"x", "v"}, {root(kW, 2, 2)});
  const Drag found = drag(a);
  REQUIRE(found.reversals.size() == 1);
  CHECK_FALSE(found.reversals[0].to);
  CHECK(found.reversals[0].from.decimal(20) == "0.70710678118654752440");
  REQUIRE(found.windows.limit());
  CHECK(found.windows.limit()->at.decimal(20) == "1.41421356237309504880");
}

TEST_CASE("two algebraic numbers at once: a drift of sqrt(2), a kick of sqrt(3)") {
  // The trace is 2 - sqrt(6) y: the limit is y = 4/sqrt(6).
  const Matrix m = product(drift(Fraction::letter(kW)), kick(Fraction::letter(kU)));
  const Windows windows = bounded_windows(m, kStiffness, {root(kW, 2, 2), root(kU, 2, 3)});
  REQUIRE(windows.limit());
  CHECK(windows.limit()->at == RealRoot(Univariate<Rational>({-8, 0, 3}), 1, 2));
}
