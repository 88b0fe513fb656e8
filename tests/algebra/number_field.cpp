// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/number_field.hpp"

#include <doctest/doctest.h>

#include <random>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/fraction.hpp"

using namespace shortfall;

namespace {

constexpr Letter kX = 0, kTheta = 3, kRoot = 4;
const NumberField::Generator kCubeRoot{kTheta, {-2, 0, 0, 1}};  // theta^3 = 2
const NumberField::Generator kSquareRoot{kRoot, {-3, 0, 1}};    // r^2 = 3
const NumberField::Generator kForestRuth{kTheta, {Rational(-1, 6), 1, -2, 1}};

Fraction random_element(std::mt19937& random) {
  Fraction result;
  for (int i = 0; i < 4; ++i) {
    Fraction term = Rational(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 4));
    for (const Letter letter : {kX, kTheta, kRoot})
      term *= Fraction::letter(letter, static_cast<int>(random() % 3));
    result += term;
  }
  return result;
}

}  // namespace

TEST_CASE("within a field a letter is the root of its polynomial, and after it a letter again") {
  const Fraction theta = Fraction::letter(kTheta);
  {
    const NumberField field({kCubeRoot});
    CHECK(theta * theta * theta == Fraction(2));
    CHECK(theta.pow(5) == Fraction(2) * theta * theta);
    CHECK(Fraction(1) / theta == theta * theta / Fraction(2));
    CHECK(Fraction::letter(kTheta, -1) == theta.pow(2) / Fraction(2));
    // 1/(1 + theta) = (1 - theta + theta^2)/3, since (1 + theta)(1 - theta + theta^2) = 1 + 2.
    CHECK(Fraction(1) / (Fraction(1) + theta) == (Fraction(1) - theta + theta * theta) / Fraction(3));
    CHECK((theta.pow(3) - Fraction(2)).is_zero());
  }
  CHECK(NumberField::current() == nullptr);
  CHECK_FALSE((theta.pow(3) - Fraction(2)).is_zero());
}

TEST_CASE("a denominator holds no generator, whatever else it holds") {
  const NumberField field({kCubeRoot, kSquareRoot});
  const Fraction x = Fraction::letter(kX), theta = Fraction::letter(kTheta), r = Fraction::letter(kRoot);
  const Fraction f = (x + r) / (x * x - theta * r);
  CHECK_FALSE(f.denominator().contains(kTheta));
  CHECK_FALSE(f.denominator().contains(kRoot));
  CHECK(f * (x * x - theta * r) == x + r);
  CHECK(Fraction(1) / (x - r) == (x + r) / (x * x - Fraction(3)));
}

TEST_CASE("the laws of a field hold for random elements of Q(x, cube root of 2, sqrt(3))") {
  const NumberField field({kCubeRoot, kSquareRoot});
  std::mt19937 random(1);
  for (int trial = 0; trial < 25; ++trial) {
    const Fraction a = random_element(random), b = random_element(random), c = random_element(random);
    CHECK((a + b) * c == a * c + b * c);
    CHECK(a * (b * c) == (a * b) * c);
    if (b.is_zero()) continue;
    CHECK(a / b * b == a);
    CHECK((a / b + c / b) == (a + c) / b);
  }
}

TEST_CASE("what is zero for the root only is zero, and cannot be divided by") {
  const NumberField field({kForestRuth});
  const Fraction theta = Fraction::letter(kTheta);
  const Fraction zero =
      Fraction(6) * theta.pow(3) - Fraction(12) * theta.pow(2) + Fraction(6) * theta - Fraction(1);
  CHECK(zero.is_zero());
  CHECK_THROWS_AS(Fraction(1) / zero, Undefined);
  // 1/theta from the polynomial itself: theta (6 theta^2 - 12 theta + 6) = 1.
  CHECK(Fraction(1) / theta == Fraction(6) * (theta - Fraction(1)).pow(2));
}
