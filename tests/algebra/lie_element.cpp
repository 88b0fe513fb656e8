// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/lie_element.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/word_series.hpp"
#include "tests/algebra/polynomial_field.hpp"
#include "tests/algebra/random_lie.hpp"

using namespace shortfall;
using Element = LieElement<Rational>;

TEST_CASE("the bracket is bilinear, antisymmetric and obeys Jacobi's identity") {
  CHECK(rc::check([] {
    const Element x = *random::lie_element(6), y = *random::lie_element(6), z = *random::lie_element(6);
    const Rational c = *random::small_rational();
    RC_ASSERT(bracket(x, y) == -bracket(y, x));
    RC_ASSERT(bracket(x, x).is_zero());
    RC_ASSERT(bracket(x + c * y, z) == bracket(x, z) + c * bracket(y, z));
    RC_ASSERT((bracket(x, bracket(y, z)) + bracket(y, bracket(z, x)) + bracket(z, bracket(x, y))).is_zero());
  }));
}

TEST_CASE("the bracket is the commutator of series of words") {
  CHECK(rc::check([] {
    const Element x = *random::lie_element(5), y = *random::lie_element(5);
    const WordSeries<Rational> xw(x), yw(y);
    WordSeries<Rational> commutator = yw * xw;
    commutator *= Rational(-1);
    commutator += xw * yw;
    RC_ASSERT(WordSeries<Rational>(bracket(x, y)) == commutator);
  }));
}

TEST_CASE("exp(ad c) x is exp(c) x exp(-c), and exp(ad -c) takes it back") {
  CHECK(rc::check([] {
    const Element c = *random::lie_element(5), x = *random::lie_element(5);
    const Element moved = exp_ad(c, x);
    RC_ASSERT(WordSeries<Rational>(moved) == exp(c) * WordSeries<Rational>(x) * exp(-c));
    RC_ASSERT(exp_ad(-c, moved) == x);
  }));
}

TEST_CASE("exp(ad c) respects brackets") {
  CHECK(rc::check([] {
    const Element c = *random::lie_element(5), x = *random::lie_element(5), y = *random::lie_element(5);
    RC_ASSERT(exp_ad(c, bracket(x, y)) == bracket(exp_ad(c, x), exp_ad(c, y)));
  }));
}

TEST_CASE("brackets of polynomial vector fields follow the structure constants") {
  // x' = x^2 y, y' = x - y^3 and x' = y + 1, y' = x y: nothing special about them.
  const Polynomial x = Polynomial::letter(0), y = Polynomial::letter(1);
  test::Brackets fields({x * x * y, x - y * y * y}, {y + Polynomial(1), x * y}, 5);
  const LyndonBasis& basis = LyndonBasis::up_to(5);
  for (int d1 = 1; d1 < 5; ++d1)
    for (int d2 = 1; d1 + d2 <= 5; ++d2)
      for (int i = 0; i < basis.dimension(d1); ++i)
        for (int j = 0; j < basis.dimension(d2); ++j) {
          const Element product = bracket(Element::basis_element(5, d1, i), Element::basis_element(5, d2, j));
          CHECK(fields.value(product, d1 + d2) == test::commutator(fields(d1, i), fields(d2, j)));
        }
}

TEST_CASE("an element is written as a sum of brackets") {
  Element x(3);
  x.at(1, 0) = 1;
  x.at(1, 1) = -1;
  x.at(2, 0) = Rational(-1, 2);
  x.at(3, 1) = Rational(2, 3);
  CHECK(text(x) == "A - B - 1/2*[A,B] + 2/3*[[A,B],B]");
  CHECK(text(Element(3)) == "0");
  CHECK(x.lowest_degree() == 1);
}

TEST_CASE("elements to different degrees do not mix, and coordinates have to fit") {
  CHECK_THROWS_AS(Element::a(3) + Element::a(4), Error);
  CHECK_THROWS_AS(bracket(Element::a(3), Element::a(4)), Error);
  CHECK_THROWS_AS(Element::homogeneous(4, 3, {Rational(1)}), Error);
}
