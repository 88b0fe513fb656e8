// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_function.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>

#include "analysis/problems/letters.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/stability/sampled.hpp"

using namespace shortfall;

namespace {

using Poly = Univariate<Rational>;

/// P and Q of the catalogue's integrator.
StabilityFunction function_of(const char* name) {
  const auto r = stability_function(find_integrator(name));
  REQUIRE(r);
  return *r;
}

StabilityFunction of_tableau(const std::string& rows) {
  const Program p = parse("integrator test\ntableau\n" + rows, "test.integrator");
  const auto r = stability_function(p);
  REQUIRE(r);
  return *r;
}

/// A polynomial with rational coefficients after all.
Poly rational(const Univariate<Algebraic>& p) {
  std::vector<Rational> c;
  for (const Algebraic& a : p.coefficients()) {
    REQUIRE(a.is_rational());
    c.push_back(a.rational());
  }
  return c;
}

}  // namespace

TEST_CASE("explicit methods of order s in s stages have the exponential's first terms") {
  // source: Hairer & Wanner (1996), IV.2, (2.12)
  CHECK(rational(function_of("explicit-euler").numerator) == Poly({1, 1}));
  for (const char* name : {"heun", "midpoint", "ralston"})
    CHECK(rational(function_of(name).numerator) == Poly({1, 1, Rational(1, 2)}));
  for (const char* name : {"kutta3"})
    CHECK(rational(function_of(name).numerator) == Poly({1, 1, Rational(1, 2), Rational(1, 6)}));
  for (const char* name : {"rk4", "rk38"})
    CHECK(rational(function_of(name).numerator) ==
          Poly({1, 1, Rational(1, 2), Rational(1, 6), Rational(1, 24)}));
  CHECK(rational(function_of("rk4").denominator) == Poly({1}));
  // source: Hairer & Wanner (1996), IV.2, (2.14): the sixth-order term of Dormand and Prince's method is
  // z^6/600.
  CHECK(rational(function_of("dormand-prince").numerator) ==
        Poly({1, 1, Rational(1, 2), Rational(1, 6), Rational(1, 24), Rational(1, 120), Rational(1, 600)}));
}

TEST_CASE("implicit methods of the literature") {
  CHECK(rational(function_of("implicit-euler").denominator) == Poly({1, -1}));
  for (const char* name : {"trapezoidal", "implicit-midpoint"}) {
    CHECK(rational(function_of(name).numerator) == Poly({1, Rational(1, 2)}));
    CHECK(rational(function_of(name).denominator) == Poly({1, Rational(-1, 2)}));
  }
  // source: Hairer & Wanner (1996), IV.3, table 3.1: Pade's (1, 2)-approximation of the exponential.
  CHECK(rational(function_of("radau-iia-3").numerator) == Poly({1, Rational(1, 3)}));
  CHECK(rational(function_of("radau-iia-3").denominator) == Poly({1, Rational(-2, 3), Rational(1, 6)}));
  // SDIRK4: gamma = 1/4 five times.
  CHECK(rational(function_of("sdirk4").denominator) ==
        Poly({1, Rational(-5, 4), Rational(5, 8), Rational(-5, 32), Rational(5, 256), Rational(-1, 1024)}));
}

TEST_CASE("A- and L-stability, and what is not") {
  struct Case {
    const char* name;
    bool a, l;
  };
  for (const Case& c : {Case{"implicit-euler", true, true},
                        {"radau-iia-3", true, true},
                        {"sdirk4", true, true},
                        {"trapezoidal", true, false},
                        {"implicit-midpoint", true, false},
                        {"explicit-euler", false, false},
                        {"heun", false, false},
                        {"rk4", false, false},
                        {"dormand-prince", false, false},
                        {"bogacki-shampine", false, false}}) {
    CAPTURE(c.name);
    const StabilityFunction r = function_of(c.name);
    const SampledFunction sampled(r);
    const StabilityProperties p = stability_properties(r);
    CHECK(p.a_stable == c.a);
    CHECK(p.l_stable == c.l);
    // The witness is one: |R(iy)| > 1 there, in binary64.
    if (!p.imaginary_axis) {
      REQUIRE(p.violated_at);
      CHECK(sampled.size({0, p.violated_at->to_double()}) > 1);
    }
    // In binary64 on the left half-plane.
    double largest = 0;
    for (double x = -40; x <= 0; x += 0.5)
      for (double y = 0; y <= 40; y += 0.5) largest = std::max(largest, sampled.size({x, y}));
    CHECK((largest <= 1 + 1e-12) == c.a);
  }
}

TEST_CASE("bounded on the imaginary axis but with a pole on the left: not A-stable") {
  // R = (1 + z/2)/(1 - z/2) mirrored has |R(iy)| = 1; as R = (1 - z/2)/(1 + z/2) its pole is at -2.
  const StabilityProperties p =
      stability_properties(stability_function(Poly({1, Rational(-1, 2)}), Poly({1, Rational(1, 2)})));
  CHECK(p.imaginary_axis);
  CHECK_FALSE(p.poles_right);
  CHECK_FALSE(p.a_stable);
}

TEST_CASE("the theta method is A-stable from theta = 1/2 on, and L-stable for 1 alone") {
  for (int k = 0; k <= 20; ++k) {
    const Rational theta(k, 20);
    const StabilityProperties p =
        stability_properties(stability_function(Poly({1, Rational(1) - theta}), Poly({1, -theta})));
    CAPTURE(theta.str());
    CHECK(p.a_stable == (k >= 10));
    CHECK(p.l_stable == (k == 20));
  }
}

TEST_CASE(
    "two equal implicit stages, stiffly accurate: A- and L-stable for 1 - sqrt(2)/2 <= gamma <= 1 + "
    "sqrt(2)/2") {
  // R = (1 + (1 - 2 g) z)/(1 - g z)^2: |R(iy)| <= 1 for small y asks for (1 - 2 g)^2 <= 2 g^2, and that is
  // enough. source: Hairer & Wanner (1996), IV.6; Alexander (1977): g = 1 - sqrt(2)/2 makes it of order two
  for (int k = 1; k <= 40; ++k) {
    const Rational g(k, 20), other = Rational(1) - g;
    CAPTURE(g.str());
    const StabilityFunction r = of_tableau("  " + g.str() + " | " + g.str() + "\n  1 | " + other.str() + " " +
                                           g.str() + "\n  b | " + other.str() + " " + g.str() + "\n");
    if (k == 20) {  // the numerator cancels one factor of the denominator
      CHECK(rational(r.denominator) == Poly({1, -1}));
      CHECK(rational(r.numerator) == Poly({1}));
      continue;
    }
    CHECK(rational(r.denominator) == Poly({1, g * -2, g * g}));
    CHECK(rational(r.numerator) == Poly({1, Rational(1) - g * 2}));
    const bool expected = (g * g * 2 - g * 4 + 1).sign() <= 0;
    CHECK(stability_properties(r).a_stable == expected);
    CHECK(stability_properties(r).l_stable == expected);
  }
}

TEST_CASE(
    "irrational coefficients: Alexander's SDIRK of two stages, gamma = 1 - sqrt(2)/2 and 1 + sqrt(2)/2, A- "
    "and L-stable to a hair") {
  constexpr Letter kW = kFirstParameter;
  using Matrix = SquareMatrix<Fraction>;
  const Fraction y = Fraction::letter(kStiffness), d = Fraction::letter(kDamping), w = Fraction::letter(kW);
  const AlgebraicLetter sqrt2{kW, RealRoot(Poly({-2, 0, 1}), 1, 2)};
  // R(A) = (1 - g A)^-2 (1 + (1 - 2 g) A) with A = {{0, 1}, {-y, -d}}, written out.
  const auto of_gamma = [&](const Fraction& g) {
    const Fraction determinant = Fraction(1) + g * d + g * g * y;
    const Matrix inverse{{(Fraction(1) + g * d) / determinant, g / determinant},
                         {-g * y / determinant, Fraction(1) / determinant}};
    const Fraction e = Fraction(1) - Fraction(2) * g;
    const Matrix above{{1, e}, {-e * y, Fraction(1) - e * d}};
    const auto r = stability_function(amplification(product(inverse, product(inverse, above)),
                                                    {"n", "h", "t", "k", "c", "w"}, {"x", "v"}, {sqrt2}));
    REQUIRE(r);
    return *r;
  };
  for (const Rational& sign : {Rational(-1), Rational(1)}) {
    const Fraction g = Fraction(1) + Fraction(sign / 2) * w;
    const StabilityFunction r = of_gamma(g);
    CHECK(r.numerator.degree() == 1);
    CHECK(r.denominator.degree() == 2);
    CHECK(r.denominator[1].to_double() ==
          doctest::Approx(-2 * (1 + sign.to_double() / std::sqrt(2.0))).epsilon(1e-14));
    const StabilityProperties p = stability_properties(r);
    CHECK(p.a_stable);
    CHECK(p.l_stable);
    CHECK(p.real_axis.always());
    // Exactly at the edge: |Q|^2 - |P|^2 has no term in y^2, so that a little less or more of gamma is not
    // A-stable.
    CHECK(p.difference[1].is_zero());
    const Fraction hair(Rational(1) / Rational(10).pow(30));
    CHECK(stability_properties(of_gamma(g - Fraction(sign) * hair)).a_stable);
    CHECK_FALSE(stability_properties(of_gamma(g + Fraction(sign) * hair)).a_stable);
  }
}

TEST_CASE("a step that is no tableau has a stability function only if it treats x and v alike") {
  CHECK_FALSE(stability_function(find_integrator("symplectic-euler")));
  CHECK_FALSE(stability_function(find_integrator("velocity-verlet")));
  CHECK(stability_function(find_integrator("implicit-midpoint")));
}

TEST_CASE("limits on the real axis") {
  const auto limit = [](const char* name) {
    const auto p = stability_properties(function_of(name));
    REQUIRE(p.real_axis.limit());
    return p.real_axis.limit()->at.decimal(12);
  };
  CHECK(limit("explicit-euler") == "2.000000000000");
  CHECK(limit("heun") == "2.000000000000");
  CHECK(limit("kutta3") == "2.512745326618");          // source: Hairer & Wanner (1996), IV.2: 2.51
  CHECK(limit("rk4") == "2.785293563405");             // 2.78
  CHECK(limit("dormand-prince") == "3.306567892635");  // 3.3
  CHECK(stability_properties(function_of("implicit-euler")).real_axis.always());
}

TEST_CASE("Routh's array agrees with the roots that a polynomial was made of: random") {
  CHECK(rc::check([] {
    Poly p({*rc::gen::inRange(1, 5)});
    bool left = true;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
      const Rational re(*rc::gen::inRange(-5, 3), 3), im(*rc::gen::inRange(0, 4), 2);
      p = p * (im.is_zero() ? Poly({-re, 1}) : Poly({re * re + im * im, re * -2, 1}));
      left = left && re.sign() < 0;
    }
    RC_ASSERT(is_hurwitz(std::vector<Algebraic>(p.coefficients().begin(), p.coefficients().end())) == left);
  }));
}
