// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/linear_solve.hpp"

#include <doctest/doctest.h>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/fraction.hpp"
#include "analysis/algebra/surd.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;

namespace {

template <class Field>
using Matrix = std::vector<std::vector<Field>>;

template <class Field>
std::vector<Field> product(const Matrix<Field>& a, const std::vector<Field>& x) {
  std::vector<Field> b;
  for (const auto& row : a) {
    Field sum(0);
    for (std::size_t j = 0; j < x.size(); ++j) sum += row[j] * x[j];
    b.push_back(sum);
  }
  return b;
}

template <class Field>
Field dot(const std::vector<Field>& x, const std::vector<Field>& y) {
  Field sum(0);
  for (std::size_t j = 0; j < x.size(); ++j) sum += x[j] * y[j];
  return sum;
}

/// y^T A = 0 and y^T b is not: nobody can solve A x = b.
template <class Field>
bool refutes(const std::vector<Field>& y, const Matrix<Field>& a, const std::vector<Field>& b) {
  if (y.size() != a.size() || dot(y, b) == Field(0)) return false;
  for (std::size_t j = 0; j < a.front().size(); ++j) {
    std::vector<Field> column;
    for (const auto& row : a) column.push_back(row[j]);
    if (!(dot(y, column) == Field(0))) return false;
  }
  return true;
}

/// A matrix of rows that are sums of a few: often singular.
template <class Element>
Matrix<Rational> matrix(std::size_t rows, std::size_t columns, std::size_t rank, Element element) {
  Matrix<Rational> base(rank, std::vector<Rational>(columns)), a(rows, std::vector<Rational>(columns));
  for (auto& row : base)
    for (auto& entry : row) entry = *element;
  for (auto& row : a)
    for (const auto& part : base) {
      const Rational factor = *element;
      for (std::size_t j = 0; j < columns; ++j) row[j] += factor * part[j];
    }
  return a;
}

}  // namespace

TEST_CASE("a system made from a solution is solved, singular or not") {
  CHECK(rc::check([] {
    const auto rows = *random::whole<std::size_t>(1, 7), columns = *random::whole<std::size_t>(1, 7);
    const auto rank = *random::whole<std::size_t>(0, 7);
    const auto a = matrix(rows, columns, rank, random::small_rational());
    std::vector<Rational> x(columns);
    for (auto& entry : x) entry = *rc::gen::arbitrary<Rational>();
    const auto b = product(a, x);
    const auto found = solve_linear(a, b);
    RC_ASSERT(found.solution.has_value());
    RC_ASSERT(product(a, *found.solution) == b);
    RC_ASSERT(found.certificate.empty());
    RC_ASSERT(columns - found.free_unknowns.size() <= std::min({rows, columns, rank}));
    for (const int k : found.free_unknowns)
      RC_ASSERT((*found.solution)[static_cast<std::size_t>(k)].is_zero());
    if (found.free_unknowns.empty()) RC_ASSERT(*found.solution == x);
  }));
}

TEST_CASE("any system is either solved or refuted by a certificate") {
  int refuted = 0;
  CHECK(rc::check([&] {
    const auto rows = *random::whole<std::size_t>(1, 7), columns = *random::whole<std::size_t>(1, 7);
    const auto a = matrix(rows, columns, *random::whole<std::size_t>(0, 5), random::small_rational());
    std::vector<Rational> b(rows);
    for (auto& entry : b) entry = *random::small_rational();
    const auto found = solve_linear(a, b);
    if (found.solution) {
      RC_ASSERT(product(a, *found.solution) == b);
    } else {
      ++refuted;
      RC_ASSERT(refutes(found.certificate, a, b));
    }
  }));
  CHECK(refuted > 10);
}

TEST_CASE("systems over rational functions are solved or refuted") {
  int refuted = 0;
  CHECK(rc::check([&] {
    Matrix<Fraction> a(3, std::vector<Fraction>(3));
    std::vector<Fraction> b(3);
    for (auto& row : a)
      for (auto& entry : row) entry = *rc::gen::arbitrary<Fraction>();
    for (auto& entry : b) entry = *rc::gen::arbitrary<Fraction>();
    if (*rc::gen::arbitrary<bool>()) {
      for (std::size_t j = 0; j < 3; ++j) a[2][j] = a[0][j] * Fraction::letter(3) + a[1][j];
    }
    const auto found = solve_linear(a, b);
    if (found.solution) {
      RC_ASSERT(product(a, *found.solution) == b);
    } else {
      ++refuted;
      RC_ASSERT(refutes(found.certificate, a, b));
    }
  }));
  CHECK(refuted > 5);
}

TEST_CASE("systems over surds are solved") {
  const Surd r = Surd::sqrt(2);
  const Matrix<Surd> a{{r, Surd(1)}, {Surd(1), r}};
  const std::vector<Surd> b{Surd(1), Surd(0)};
  const auto found = solve_linear(a, b);
  REQUIRE(found.solution.has_value());
  CHECK((*found.solution)[0] == r);
  CHECK((*found.solution)[1] == -1);
  const auto none = solve_linear(Matrix<Surd>{{r, Surd(2)}, {Surd(1), r}}, b);
  CHECK_FALSE(none.solution.has_value());
  CHECK(refutes(none.certificate, Matrix<Surd>{{r, Surd(2)}, {Surd(1), r}}, b));
}

TEST_CASE(
    "Hilbert's matrix of order ten gives the inverse's first column, whose entries are known whole numbers") {
  Matrix<Rational> a(10, std::vector<Rational>(10));
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = Rational(1, i + j + 1);
  std::vector<Rational> b(10);
  b[0] = 1;
  const auto found = solve_linear(a, b);
  REQUIRE(found.solution.has_value());
  // Choi (1983), Tricks or treats with the Hilbert matrix: its formula for the inverse's entries, in the
  // first column.
  for (int i = 0; i < 10; ++i)
    CHECK((*found.solution)[static_cast<std::size_t>(i)] ==
          (i % 2 ? -1 : 1) * (i + 1) * binomial(10 + i, 9) * binomial(10, 9 - i));
}

TEST_CASE("systems without rows, without columns or with free unknowns have plain answers") {
  const auto nothing = solve_linear<Rational>({}, {});
  REQUIRE(nothing.solution.has_value());
  CHECK(nothing.solution->empty());
  CHECK(solve_linear<Rational>({{}}, {0}).solution.has_value());
  CHECK(solve_linear<Rational>({{}}, {1}).certificate == std::vector<Rational>{1});
  const auto free = solve_linear<Rational>({{0, 2, 4}}, {6});
  CHECK(*free.solution == std::vector<Rational>{0, 3, 0});
  CHECK(free.free_unknowns == std::vector<int>{0, 2});
  CHECK_THROWS_AS(solve_linear<Rational>({{1}}, {1, 2}), Error);
  CHECK_THROWS_AS(solve_linear<Rational>({{1}, {1, 2}}, {1, 2}), Error);
}
