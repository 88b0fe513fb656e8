// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/rational_system.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "analysis/algebra/linear_solve.hpp"
#include "analysis/algebra/surd.hpp"
#include "tests/algebra/random.hpp"

using namespace shortfall;
using Row = std::vector<Rational>;

TEST_CASE("solutions solve, obstructions annihilate, and together they decide as elimination does") {
  CHECK(rc::check([] {
    const auto count = static_cast<std::size_t>(*random::whole(1, 6));
    const auto unknowns = static_cast<std::size_t>(*random::whole(1, 6));
    std::vector<Row> rows;
    for (std::size_t r = 0; r < count; ++r)
      rows.push_back(*rc::gen::container<Row>(
          unknowns, rc::gen::oneOf(rc::gen::just(Rational(0)), random::small_rational())));
    const Row right = *rc::gen::container<Row>(count, random::small_rational());
    const RationalSystem system(rows, unknowns);
    for (const Row& y : system.obstructions())
      for (std::size_t k = 0; k < unknowns; ++k) {
        Rational sum;
        for (std::size_t r = 0; r < count; ++r) sum += y[r] * rows[r][k];
        RC_ASSERT(sum.is_zero());
      }
    const Row residuals = system.residuals(right);
    const bool solvable =
        std::ranges::all_of(residuals, [](const Rational& value) { return value.is_zero(); });
    const LinearSolution<Rational> other = solve_linear(rows, right);
    RC_ASSERT(solvable == other.solution.has_value());
    if (!solvable) return;
    RC_ASSERT(static_cast<int>(other.free_unknowns.size()) == system.kernel_dimension());
    const Row x = system.solution(right);
    for (std::size_t r = 0; r < count; ++r) {
      Rational sum;
      for (std::size_t k = 0; k < unknowns; ++k) sum += rows[r][k] * x[k];
      RC_ASSERT(sum == right[r]);
    }
  }));
}

TEST_CASE("obstructions are whole numbers without a common factor; the first unknown stays free") {
  const RationalSystem system({{Rational(1, 2), 1}, {Rational(1, 3), Rational(2, 3)}}, 2);
  REQUIRE(system.obstructions().size() == 1);
  CHECK(system.obstructions()[0] == Row{2, -3});
  CHECK(system.kernel_dimension() == 1);
  CHECK(system.solution(Row{3, 2}) == Row{0, 3});
}

TEST_CASE("right-hand sides may lie in a larger field") {
  const Surd root = Surd::sqrt(2);
  const RationalSystem system({{2, 0}, {0, 4}}, 2);
  CHECK(system.solution(std::vector<Surd>{root, Surd(1) + root}) ==
        std::vector<Surd>{root / Surd(2), (Surd(1) + root) / Surd(4)});
}
