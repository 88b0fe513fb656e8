// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/lie_quotient.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <vector>

#include "analysis/algebra/homological_equation.hpp"
#include "analysis/algebra/row_echelon.hpp"
#include "tests/algebra/polynomial_field.hpp"
#include "tests/algebra/random_lie.hpp"

using namespace shortfall;
using Element = LieElement<Rational>;

namespace {

constexpr VectorFields kMechanical = VectorFields::mechanical;

/// x'' = a(x) in the plane; letters 0, 1 are x and 2, 3 are v.
struct Plane {
  test::Field drift{Polynomial::letter(2), Polynomial::letter(3), Polynomial(), Polynomial()};
  test::Field kick;
};

/// All powers of x and y to a degree, with whole numbers from -7 to 7 that follow no rule.
Polynomial without_symmetry(int degree, int seed) {
  Polynomial result;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) {
      seed = (seed * 137 + 71) % 1009;
      result += Polynomial::letter(0, i) * Polynomial::letter(1, j) * Polynomial(seed % 15 - 7);
    }
  return result;
}

/// a = -grad V.
Plane conservative() {
  const Polynomial v = without_symmetry(8, 1);
  Plane result;
  result.kick = {Polynomial(), Polynomial(), -v.derivative(0), -v.derivative(1)};
  return result;
}

Plane with_curl() {
  Plane result;
  result.kick = {Polynomial(), Polynomial(), without_symmetry(7, 2), without_symmetry(7, 3)};
  return result;
}

/// The coefficients of all components, in one row over the monomials that occur.
std::vector<std::vector<Rational>> rows(const std::vector<test::Field>& fields) {
  std::map<std::pair<std::size_t, Monomial>, std::size_t> columns;
  for (const test::Field& f : fields)
    for (std::size_t i = 0; i < f.size(); ++i)
      for (const auto& term : f[i].terms()) columns.try_emplace({i, term.monomial}, columns.size());
  std::vector<std::vector<Rational>> result;
  for (const test::Field& f : fields) {
    auto& row = result.emplace_back(columns.size());
    for (std::size_t i = 0; i < f.size(); ++i)
      for (const auto& term : f[i].terms()) row[columns.at({i, term.monomial})] = term.coefficient;
  }
  return result;
}

}  // namespace

TEST_CASE("the mechanical quotient has the dimensions 2, 1, 2, 2, 4, 5, 10, 14, 25, 39, 69, 110") {
  // To degree 7 also McLachlan & Atela (1992) and Murua (1999) count so many order conditions of RKN
  // splittings.
  const std::vector<int> known{0, 2, 1, 2, 2, 4, 5, 10, 14, 25, 39, 69, 110};
  const LieQuotient& quotient = LieQuotient::of(kMechanical, 12);
  for (int d = 1; d <= 12; ++d) CHECK(quotient.dimension(d) == known[static_cast<std::size_t>(d)]);
}

TEST_CASE("the structure theorem and the ideal count alike: two derivations of one number, to degree 12") {
  const LieQuotient& quotient = LieQuotient::of(kMechanical, 12);
  const std::vector<int> structure = mechanical_dimensions(12);
  for (int d = 1; d <= 12; ++d) CHECK(quotient.dimension(d) == structure[static_cast<std::size_t>(d)]);
}

TEST_CASE("by the structure theorem dimensions grow by the published entropy, 1.8249") {
  // McLachlan & Murua (2019), abstract. The dimension of degree n behaves like 1.8249^n / n.
  const std::vector<int> c = mechanical_dimensions(40);
  CHECK(40.0 * c[40] / (39.0 * c[39]) == doctest::Approx(1.8249).epsilon(5e-5));
}

TEST_CASE("without knowing more about drifts and kicks nothing vanishes") {
  const LieQuotient& quotient = LieQuotient::of(VectorFields::any, 7);
  for (int d = 1; d <= 7; ++d) {
    CHECK(quotient.dimension(d) == witt_dimension(d));
    CHECK(quotient.relations(d).empty());
  }
}

TEST_CASE("[B,[B,[B,A]]] vanishes, and it is the only relation of degree 4") {
  const Element a = Element::a(4), b = Element::b(4);
  const LieQuotient& quotient = LieQuotient::of(kMechanical, 4);
  CHECK(quotient.normal_form(bracket(b, bracket(b, bracket(b, a)))).is_zero());
  CHECK(quotient.relations(4).size() == 1);
  CHECK(quotient.relations(3).empty());
}

TEST_CASE("the relations are an ideal: brackets with them vanish again") {
  const LieQuotient& quotient = LieQuotient::of(kMechanical, 8);
  for (int d = 4; d < 8; ++d)
    for (const auto& relation : quotient.relations(d)) {
      const Element r = Element::homogeneous(8, d, relation);
      CHECK(quotient.normal_form(r).is_zero());
      CHECK(quotient.normal_form(bracket(r, Element::a(8))).is_zero());
      CHECK(quotient.normal_form(bracket(r, Element::b(8))).is_zero());
    }
}

TEST_CASE("normal forms are equal exactly for one class, and brackets do not see the difference") {
  const LieQuotient& quotient = LieQuotient::of(kMechanical, 7);
  CHECK(rc::check([&] {
    const Element x = *random::lie_element(7), y = *random::lie_element(7);
    const Element nx = quotient.normal_form(x), ny = quotient.normal_form(y);
    RC_ASSERT(quotient.normal_form(nx) == nx);
    RC_ASSERT(quotient.normal_form(bracket(nx, ny)) == quotient.normal_form(bracket(x, y)));
    RC_ASSERT(quotient.normal_form(x + y) == nx + ny);
  }));
}

TEST_CASE(
    "relations hold for polynomial forces in the plane, with and without a potential, and no others do") {
  constexpr int kDegree = 8;
  const LieQuotient& quotient = LieQuotient::of(kMechanical, kDegree);
  const LyndonBasis& basis = LyndonBasis::up_to(kDegree);
  for (const Plane& plane : {conservative(), with_curl()}) {
    test::Brackets fields(plane.drift, plane.kick, kDegree);
    for (int d = 1; d <= kDegree; ++d) {
      for (const auto& relation : quotient.relations(d))
        CHECK(test::is_zero(fields.value(Element::homogeneous(kDegree, d, relation), d)));
      // What remains is independent; kicks and drifts scale apart, so each number of kicks for itself.
      std::map<int, std::vector<test::Field>> by_kicks;
      for (const int i : quotient.basis(d))
        by_kicks[basis.words(d)[static_cast<std::size_t>(i)].count_b()].push_back(fields(d, i));
      for (const auto& [kicks, values] : by_kicks) {
        const auto matrix = rows(values);
        CHECK(row_echelon(matrix, matrix.front().size()).rank() == static_cast<int>(values.size()));
      }
    }
  }
}

TEST_CASE("[c, A + B] = r is solved where it can be, and the functionals see where it cannot") {
  for (const VectorFields kind : {VectorFields::any, kMechanical}) {
    for (int n = 2; n <= 8; ++n) {
      const LieQuotient& quotient = LieQuotient::of(kind, n);
      const RationalSystem& equation = homological_equation(kind, n);
      const Element f = Element::a(n) + Element::b(n);
      CHECK(equation.kernel_dimension() == (n == 2 ? 1 : 0));
      CHECK(static_cast<int>(equation.obstructions().size()) ==
            quotient.dimension(n) - quotient.dimension(n - 1) + equation.kernel_dimension());
      for (int k = 0; k < quotient.dimension(n - 1); ++k) {
        std::vector<Rational> c(static_cast<std::size_t>(quotient.dimension(n - 1)));
        c[static_cast<std::size_t>(k)] = 1;
        const Element element = Element::homogeneous(n, n - 1, quotient.lifted(n - 1, c));
        const auto r = quotient.coordinates(n, bracket(element, f).part(n));
        for (const Rational& value : equation.residuals(r)) CHECK(value.is_zero());
        const auto found = equation.solution(r);
        const Element back = Element::homogeneous(n, n - 1, quotient.lifted(n - 1, found));
        CHECK(quotient.coordinates(n, bracket(back, f).part(n)) == r);
      }
    }
  }
}

TEST_CASE("in degree 1 the solution is a kick alone") {
  const RationalSystem& equation = homological_equation(VectorFields::any, 2);
  CHECK(equation.solution(std::vector<Rational>{Rational(1, 2)}) ==
        std::vector<Rational>{0, Rational(-1, 2)});
}

TEST_CASE("the obstruction of degree 3 is the sum of the coefficients of [A,[A,B]] and [[A,B],B]") {
  for (const VectorFields kind : {VectorFields::any, kMechanical}) {
    const auto functionals = homological_equation(kind, 3).obstructions();
    REQUIRE(functionals.size() == 1);
    CHECK(functionals[0] == std::vector<Rational>{1, 1});
  }
}
