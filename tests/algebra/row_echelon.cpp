// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/row_echelon.hpp"

#include <doctest/doctest.h>

#include "tests/algebra/random.hpp"

using namespace shortfall;

TEST_CASE("a reduced basis spans the rows, with ones at its pivots and zeros above and below them") {
  CHECK(rc::check([] {
    const auto size = static_cast<std::size_t>(*random::whole(1, 6));
    const auto count = static_cast<std::size_t>(*random::whole(1, 6));
    std::vector<std::vector<Rational>> rows;
    for (std::size_t r = 0; r < count; ++r)
      rows.push_back(*rc::gen::container<std::vector<Rational>>(size, random::small_rational()));
    const RowEchelon reduced = row_echelon(rows, size);
    for (std::size_t r = 0; r < reduced.rows.size(); ++r)
      for (std::size_t s = 0; s < reduced.rows.size(); ++s)
        RC_ASSERT(reduced.rows[s][static_cast<std::size_t>(reduced.pivots[r])] == Rational(r == s ? 1 : 0));
    for (std::vector<Rational> row : rows) {
      for (std::size_t r = 0; r < reduced.rows.size(); ++r) {
        const Rational factor = row[static_cast<std::size_t>(reduced.pivots[r])];
        for (std::size_t k = 0; k < size; ++k) row[k] -= factor * reduced.rows[r][k];
      }
      RC_ASSERT(row == std::vector<Rational>(size));
    }
  }));
}

TEST_CASE("pivots are looked for in the first columns only, and the rest is carried along") {
  const RowEchelon reduced = row_echelon({{2, 4, 1, 0}, {1, 2, 0, 1}}, 2);
  REQUIRE(reduced.rank() == 1);
  CHECK(reduced.pivots == std::vector<int>{0});
  CHECK(reduced.rows[0] == std::vector<Rational>{1, 2, Rational(1, 2), 0});
}
