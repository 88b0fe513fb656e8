// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/windows.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "analysis/problems/letters.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/stability/stability.hpp"
#include "tests/stability/oscillator_step.hpp"

using namespace shortfall;
using testing::y;

namespace {

Windows windows_of(const Fraction& trace, const Fraction& determinant) {
  return bounded_windows({{0, 1}, {-determinant, trace}}, kStiffness);
}

// Omelyan, Mryglod & Folk (2002), Optimized Forest-Ruth- and Suzuki-like algorithms for integration of motion
// in many-body systems, Computer Physics Communications 146, (20)-(23): the position form.
const char* const kPefrl = R"(integrator pefrl
  param xi     = 0.1786178958448091
  param lambda = -0.2123418310626054
  param chi    = -0.06626458266981849

step
  x = x + xi*h*v
  v = v + (1 - 2*lambda)/2*h*a(x, v, t + xi*h)
  x = x + chi*h*v
  v = v + lambda*h*a(x, v, t + (xi + chi)*h)
  x = x + (1 - 2*(chi + xi))*h*v
  v = v + lambda*h*a(x, v, t + (1 - xi - chi)*h)
  x = x + chi*h*v
  v = v + (1 - 2*lambda)/2*h*a(x, v, t + (1 - xi)*h)
  x = x + xi*h*v
)";

/// The largest |x| of 20000 steps in binary64.
double pefrl_reach(double z) {
  const double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
  double x = 1, v = 0.3, largest = 0;
  for (int n = 0; n < 20000 && largest < 1e12; ++n) {
    x += xi * v;
    v -= (1 - 2 * lambda) / 2 * z * z * x;
    x += chi * v;
    v -= lambda * z * z * x;
    x += (1 - 2 * (chi + xi)) * v;
    v -= lambda * z * z * x;
    x += chi * v;
    v -= (1 - 2 * lambda) / 2 * z * z * x;
    x += xi * v;
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

bool inside(const Windows& windows, double z) {
  for (const Window& w : windows.windows)
    if ((!w.from || w.from->at.to_double() < z) && (!w.to || z < w.to->at.to_double())) return true;
  return false;
}

}  // namespace

TEST_CASE("PEFRL is stable up to 2.989449545906729..., and again further out") {
  const Program pefrl = parse(kPefrl, "pefrl.integrator");
  const Windows windows = oscillator_windows(pefrl);
  const auto limit = stability_limit(pefrl);
  REQUIRE(limit);
  CHECK(limit->decimal(15) == "2.989449545906729");
  REQUIRE(windows.windows.size() >= 2);
  for (std::size_t i = 0; i < windows.windows.size(); ++i) {
    const Window& w = windows.windows[i];
    CHECK(w.keeps);
    REQUIRE(w.to);
    // In the middle of each window and of each hole, by 20000 steps.
    const double from = w.from ? w.from->at.to_double() : 0, to = w.to->at.to_double();
    CAPTURE(from);
    CAPTURE(to);
    CHECK(pefrl_reach((from + to) / 2) < 1e6);
    if (i + 1 < windows.windows.size())
      CHECK(pefrl_reach((to + windows.windows[i + 1].from->at.to_double()) / 2) > 1e9);
    else
      CHECK(pefrl_reach(1.05 * to) > 1e9);
  }
}

TEST_CASE("a window with a hole of known shape: trace 2 - 8 y (1 - y)") {
  // |trace| <= 2 for 0 <= y <= 1 as 8 y (1 - y) <= 2 < 4, beyond y = 1 the trace is above 2.
  const Windows one = windows_of(Fraction(2) - Fraction(8) * y() * (Fraction(1) - y()), 1);
  REQUIRE(one.windows.size() == 1);
  CHECK(one.windows[0].to->at.rational() == Rational(1));
  // trace 2 - 20 y (1 - y): below -2 where y (1 - y) > 1/5: (5 -+ sqrt(5))/10.
  const Windows two = windows_of(Fraction(2) - Fraction(20) * y() * (Fraction(1) - y()), 1);
  REQUIRE(two.windows.size() == 2);
  CHECK(two.windows[0].to->at.decimal(20) == "0.27639320225002103036");
  CHECK(two.windows[1].from->at.decimal(20) == "0.72360679774997896964");
  CHECK(two.windows[1].to->at.rational() == Rational(1));
  CHECK(two.from_zero());
  CHECK_FALSE(two.always());
  // At an edge of a companion matrix, eigenvalue -1 or 1 twice: one Jordan block, so the edge is left out.
  CHECK_FALSE(two.windows[0].to_included);
  CHECK(two.limit()->growth.degree == 1);
}

TEST_CASE("a diagonalisable matrix includes its edge, and touching 2 from inside makes no hole") {
  // Rotation by an angle: trace 2 - 4 y^2 touches nothing below y = 1; as cosine and sine, [[c, -s], [s, c]]
  // with the tangent t of the half angle is rational: c = (1 - t^2)/(1 + t^2), s = 2 t/(1 + t^2). Bounded for
  // every t, t = infinity left out.
  const Fraction t = y(), c = (Fraction(1) - t * t) / (Fraction(1) + t * t),
                 s = Fraction(2) * t / (Fraction(1) + t * t);
  const Windows rotation = bounded_windows({{c, -s}, {s, c}}, kStiffness);
  CHECK(rotation.always());
  CHECK(rotation.windows[0].keeps);
  // trace 2 - y (4 - y)... touches -2 at y = 2 and comes back: (y - 2)^2 - 2.
  const Windows touching = windows_of((y() - Fraction(2)) * (y() - Fraction(2)) - Fraction(2), 1);
  REQUIRE(touching.windows.size() == 2);  // at y = 2 itself the companion matrix has a Jordan block
  CHECK(touching.windows[0].to->at.rational() == Rational(2));
  CHECK(touching.windows[1].from->at.rational() == Rational(2));
  CHECK_FALSE(touching.windows[0].to_included);
}

TEST_CASE("stable at single values only") {
  // diag(1 + (y - 3)^2, 1/2): bounded exactly at y = 3.
  const Windows windows = bounded_windows(
      {{Fraction(1) + (y() - Fraction(3)) * (y() - Fraction(3)), 0}, {0, Rational(1, 2)}}, kStiffness);
  REQUIRE(windows.windows.size() == 1);
  CHECK(windows.windows[0].is_point());
  CHECK(windows.windows[0].from->at.rational() == Rational(3));
  CHECK_FALSE(windows.from_zero());
  // A Jordan block whose coupling vanishes at y = 5: bounded only there.
  const Windows block = bounded_windows({{1, y() - Fraction(5)}, {0, 1}}, kStiffness);
  REQUIRE(block.windows.size() == 1);
  CHECK(block.windows[0].is_point());
  CHECK(block.windows[0].from->at.rational() == Rational(5));
}

TEST_CASE("a pole ends a window") {
  // 1/(y - 1): inside the circle for |y - 1| > 1, that is for y > 2; no step exists at y = 1.
  const Windows windows = bounded_windows({{Fraction(1) / (y() - Fraction(1))}}, kStiffness);
  REQUIRE(windows.windows.size() == 1);
  CHECK(windows.windows[0].from->at.rational() == Rational(2));
  CHECK(windows.windows[0].from_included);
  CHECK_FALSE(windows.windows[0].to);
  // (y - 1)/(y - 1)^... a pole between two stable windows: 1/2 + 1/(1000 (y - 1)^2).
  const Fraction near =
      Fraction(Rational(1, 2)) + Fraction(1) / (Fraction(1000) * (y() - Fraction(1)) * (y() - Fraction(1)));
  const Windows hole = bounded_windows({{near}}, kStiffness);
  REQUIRE(hole.windows.size() == 2);
  CHECK(hole.windows[0].to->at.decimal(15) == "0.955278640450004");  // 1 - 1/sqrt(500)
  CHECK(hole.windows[1].from->at.decimal(15) == "1.044721359549996");
}

TEST_CASE("windows of random second-order steps agree with the roots of their characteristic polynomials") {
  CHECK(rc::check([] {
    const auto random_polynomial = [](int degree) {
      Polynomial p;
      for (int k = 0; k <= degree; ++k)
        p += Polynomial(Rational(*rc::gen::inRange(-8, 9), 4)) * Polynomial::letter(kStiffness, k);
      return p;
    };
    const Fraction trace(random_polynomial(2)), determinant(random_polynomial(1));
    const Windows windows = windows_of(trace, determinant);
    for (int i = 1; i < 40; ++i) {
      const Rational at(i, 7);
      const double t = trace.evaluate({{kStiffness, at}}).to_double(),
                   d = determinant.evaluate({{kStiffness, at}}).to_double();
      // Both roots inside or on the circle: |d| <= 1 and |t| <= 1 + d; stay clear of the edges.
      const double margin = std::min(1 - std::abs(d), 1 + d - std::abs(t));
      const bool on_circle = determinant == Fraction(1);
      if (on_circle ? std::abs(std::abs(t) - 2) < 1e-9 : std::abs(margin) < 1e-9) continue;
      RC_ASSERT(inside(windows, at.to_double()) == (on_circle ? std::abs(t) < 2 : margin > 0));
    }
  }));
}

TEST_CASE("between two roots there is a sample") {
  const auto roots = positive_roots(
      {Univariate<Rational>({-2, 0, 1}), Univariate<Rational>({-3, 0, 1}), Univariate<Rational>({-5, 1})});
  const auto samples = samples_between(roots);
  REQUIRE(samples.size() == roots.size() + 1);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    CHECK(roots[i].compare(samples[i]) == 1);
    CHECK(roots[i].compare(samples[i + 1]) == -1);
  }
}
