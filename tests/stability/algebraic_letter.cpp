// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/algebraic_letter.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "analysis/stability/algebraic_over.hpp"

using namespace shortfall;

namespace {

constexpr Letter kX = 0, kR = 1, kS = 2;

AlgebraicLetter cube_root_of_2() { return {kR, RealRoot(Univariate<Rational>({-2, 0, 0, 1}), 1, 2)}; }
AlgebraicLetter square_root(int n, Letter letter) {
  return {letter, RealRoot(Univariate<Rational>({-n, 0, 1}), 1, n)};
}

Fraction letter(Letter l, int power = 1) { return Fraction::letter(l, power); }

/// A small random rational function in x and r.
Fraction random_fraction() {
  const auto polynomial = [] {
    Polynomial p;
    for (int i = 0; i < 3; ++i)
      p += Polynomial(Rational(*rc::gen::inRange(-9, 10), *rc::gen::inRange(1, 5))) *
           Polynomial::letter(kX, *rc::gen::inRange(0, 3)) * Polynomial::letter(kR, *rc::gen::inRange(0, 5));
    return p;
  };
  const Polynomial below = polynomial();
  return below.is_zero() ? Fraction(polynomial()) : Fraction(polynomial(), below);
}

double value(const Fraction& f, double x, double r) {
  const auto of = [&](const Polynomial& p) {
    double sum = 0;
    for (const Polynomial::Term& t : p.terms())
      sum += t.coefficient.to_double() * std::pow(x, t.monomial.exponent(kX)) *
             std::pow(r, t.monomial.exponent(kR));
    return sum;
  };
  return of(f.numerator()) / of(f.denominator());
}

}  // namespace

TEST_CASE("powers of the cube root of 2 are reduced, and leave denominators") {
  const auto r = cube_root_of_2();
  CHECK(reduced(letter(kR, 4), {r}) == Fraction(2) * letter(kR));
  // 1/(2 - w) = (4 + 2 w + w^2)/6, since (2 - w)(4 + 2 w + w^2) = 8 - 2.
  CHECK(reduced(Fraction(1) / (Fraction(2) - letter(kR)), {r}) ==
        (Fraction(4) + Fraction(2) * letter(kR) + letter(kR, 2)) / Fraction(6));
  CHECK_THROWS_AS(reduced(Fraction(1) / (letter(kR, 3) - Fraction(2)), {r}), Undefined);
}

TEST_CASE("a reduced function has the same values, and equal ones have one form: random") {
  const auto r = cube_root_of_2();
  CHECK(rc::check([&] {
    const Fraction f = random_fraction(), g = random_fraction();
    Fraction once, sum;
    try {
      once = reduced(f, {r});
      sum = reduced(f + g, {r});
    } catch (const Undefined&) {
      return;  // a denominator that is 0 for this number
    }
    RC_ASSERT(!once.denominator().contains(kR));
    RC_ASSERT(once.numerator().degree(kR) < 3);
    RC_ASSERT(reduced(once + g, {r}) == sum);
    RC_ASSERT(reduced(f + (letter(kR, 3) - Fraction(2)) * letter(kX), {r}) == once);
    const double x = 0.7390851332, w = std::cbrt(2.0), a = value(f, x, w), b = value(once, x, w);
    RC_ASSERT(std::abs(a - b) <= 1e-6 * (1 + std::abs(a)));
  }));
}

TEST_CASE("one number generates sqrt(2), sqrt(3) and the cube root of 2 together") {
  const CommonField field = common_field({square_root(2, kX), square_root(3, kS), cube_root_of_2()});
  CHECK(field.generator->degree() == 12);
  CHECK(field.values[0] * field.values[0] == Algebraic(2));
  CHECK(field.values[1] * field.values[1] == Algebraic(3));
  CHECK(field.values[2] * field.values[2] * field.values[2] == Algebraic(2));
  CHECK(field.values[0].sign() == 1);
  CHECK(field.values[1].sign() == 1);
  CHECK((field.values[0] * field.values[1] - Algebraic(Rational::parse("2.449489742783178"))).sign() == 1);
  CHECK((field.values[0] * field.values[1] - Algebraic(Rational::parse("2.449489742783179"))).sign() == -1);
}

TEST_CASE("numbers that depend on each other share a small field") {
  const CommonField field = common_field({square_root(2, kX), square_root(8, kS)});
  CHECK(field.generator->degree() == 2);
  CHECK(field.values[1] == field.values[0] * Algebraic(2));
}

TEST_CASE("only roots of the polynomial itself are found, not those of its conjugates") {
  // x^2 - 2 r with r = sqrt(2): the norm x^4 - 8 has the positive root 8^(1/4); with r = -sqrt(2) there is
  // none.
  const CommonField field = common_field({square_root(2, kR)});
  const Algebraic r = field.values[0];
  const auto plus = positive_roots({Univariate<Algebraic>({r * Algebraic(-2), 0, 1})}, field.generator);
  REQUIRE(plus.size() == 1);
  CHECK(plus[0].root.decimal(30) == "1.681792830507429086062250952466");
  CHECK(positive_roots({Univariate<Algebraic>({r * Algebraic(2), 0, 1})}, field.generator).empty());
  // (x - sqrt(2) + 1)(x - 3): its norm has the root sqrt(2) + 1 of the conjugate... with the sign turned.
  const Univariate<Algebraic> two =
      Univariate<Algebraic>({Algebraic(1) - r, 1}) * Univariate<Algebraic>({-3, 1});
  const auto roots = positive_roots({two, two}, field.generator);
  REQUIRE(roots.size() == 2);
  CHECK(roots[0].root.decimal(20) == "0.41421356237309504880");
  CHECK(roots[1].root.is_rational());
}

TEST_CASE("a tower of fields is a field, exactly and in order") {
  // s = sqrt(1 + sqrt(2)) over Q(sqrt(2)).
  const CommonField field = common_field({square_root(2, kR)});
  const Algebraic r = field.values[0];
  const auto roots = positive_roots({Univariate<Algebraic>({Algebraic(-1) - r, 0, 1})}, field.generator);
  REQUIRE(roots.size() == 1);
  const auto extension = std::make_shared<AlgebraicOver::Extension>(
      AlgebraicOver::Extension{field.generator, roots[0].root, roots[0].polynomial});
  const AlgebraicOver s(Univariate<Algebraic>({0, 1}), extension);
  CHECK(s * s == AlgebraicOver(Algebraic(1) + r));
  CHECK((s - AlgebraicOver(Algebraic(Rational::parse("1.5537739740300373073")))).sign() == 1);
  CHECK((s - AlgebraicOver(Algebraic(Rational::parse("1.5537739740300373074")))).sign() == -1);
  CHECK(s.abs() == s);
  CHECK((-s).abs() == s);
  CHECK_THROWS_AS(s / (s * s - AlgebraicOver(r) - AlgebraicOver(1)), Undefined);
  CHECK(rc::check([&] {
    const auto element = [&] {
      AlgebraicOver a;
      for (int i = 0; i < 3; ++i)
        a = a * s +
            AlgebraicOver(Algebraic(*rc::gen::inRange(-9, 10)) + r * Algebraic(*rc::gen::inRange(-9, 10)));
      return a;
    };
    const AlgebraicOver a = element(), b = element(), c = element();
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    if (!b.is_zero()) RC_ASSERT(a / b * b == a);
    RC_ASSERT((a * b).sign() == a.sign() * b.sign());
    RC_ASSERT((a < b) + (b < a) + (a == b) == 1);
  }));
}

TEST_CASE("a modulus that factors is replaced by the factor of its root") {
  // s = sqrt(2), held as a root of (x^2 - 2)(x - 5) over Q.
  const Univariate<Algebraic> modulus = Univariate<Algebraic>({-2, 0, 1}) * Univariate<Algebraic>({-5, 1});
  const auto extension = std::make_shared<AlgebraicOver::Extension>(
      AlgebraicOver::Extension{nullptr, RealRoot(Univariate<Rational>({-2, 0, 1}), 1, 2), modulus});
  const AlgebraicOver s(Univariate<Algebraic>({0, 1}), extension);
  SUBCASE("by a zero") {
    CHECK((s * s - AlgebraicOver(2)).is_zero());
    CHECK(extension->modulus.degree() == 2);
  }
  SUBCASE("by a division") {
    const AlgebraicOver inverse = AlgebraicOver(1) / (s - AlgebraicOver(5));  // shares x - 5
    CHECK(inverse * (s - AlgebraicOver(5)) == AlgebraicOver(1));
    CHECK(extension->modulus.degree() == 2);
  }
  CHECK(s.sign() == 1);
  CHECK((s - AlgebraicOver(2)).sign() == -1);
}
