// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets against trees: two derivations of a splitting's modified equation that share no line of code.
#include <doctest/doctest.h>

#include <map>
#include <string>
#include <utility>

#include "analysis/algebra/row_echelon.hpp"
#include "analysis/algebra/tree_series.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/program/parse.hpp"
#include "analysis/series/order.hpp"
#include "analysis/series/splitting_processing.hpp"
#include "analysis/series/splitting_reading.hpp"
#include "tests/series/random_splitting.hpp"

using namespace shortfall;

namespace {

Program program_of(const SplittingParts<Rational>& parts) {
  std::string text = "integrator test\nsplitting\n";
  for (const auto& [kick, weight] : parts) text += (kick ? "  kick " : "  drift ") + weight.str() + "\n";
  return parse(text, "test.integrator");
}

/// The sum of brackets as a series of elementary differentials: A is the tree x' = v, B the tree v' = a.
TreeSeries<Rational> in_trees(const TreeTable& table, const LieElement<Rational>& x) {
  std::map<std::pair<int, int>, TreeSeries<Rational>> known;
  for (const auto& [letter, function] : {std::pair{0, 1}, {1, 0}}) {  // function 0 is a, function 1 the drift
    TreeSeries<Rational> node(table.size(), Rational(0));
    node[table.node(function)] = 1;
    known[{1, letter}] = node;
  }
  TreeSeries<Rational> sum(table.size(), Rational(0));
  for (int d = 1; d <= x.degree(); ++d)
    for (int i = 0; i < x.basis().dimension(d); ++i) {
      if (d > 1) {
        const auto [left, right] = x.basis().factors(d, i);
        known[{d, i}] = commutator(table, known.at(left), known.at(right));
      }
      for (TreeId t = 0; t < table.size(); ++t) sum[t] += x.at(d, i) * known.at({d, i})[t];
    }
  return sum;
}

}  // namespace

TEST_CASE("the modified equation of random splittings in brackets is the one in trees, to order 6") {
  const TreeTable table(force_class("position_only").signature, 6);
  CHECK(rc::check([&] {
    const SplittingParts<Rational> parts = *random::consistent_splitting(5);
    const SeriesSource source(program_of(parts), {});
    RC_ASSERT(source.step<Rational>(table).field == in_trees(table, splitting_logarithm(parts, 6)));
  }));
}

TEST_CASE("relations of the mechanical quotient are zero in trees, and what remains is independent") {
  constexpr int kDegree = 7;
  const TreeTable table(force_class("position_only").signature, kDegree);
  const LieQuotient& quotient = LieQuotient::of(VectorFields::mechanical, kDegree);
  for (int d = 1; d <= kDegree; ++d) {
    for (const auto& relation : quotient.relations(d))
      CHECK(in_trees(table, LieElement<Rational>::homogeneous(kDegree, d, relation)) ==
            TreeSeries<Rational>(table.size(), Rational(0)));
    std::vector<std::vector<Rational>> rows;
    for (const int i : quotient.basis(d))
      rows.push_back(in_trees(table, LieElement<Rational>::basis_element(kDegree, d, i)));
    CHECK(row_echelon(rows, table.size()).rank() == quotient.dimension(d));
  }
}

TEST_CASE("orders of the catalogue's splittings for x'' = a(x) agree with those from trees") {
  int compared = 0;
  for (const Program& program : catalogue()) {
    const SplittingReading reading = splitting_reading(program);
    if (!reading.is_splitting()) continue;
    std::visit(
        [&](const auto& parts) {
          if constexpr (requires { parts.step; }) {
            if (!parts.start.empty() || !parts.finish.empty()) return;
            const int mine = splitting_order(splitting_logarithm(parts.step, 7), VectorFields::mechanical);
            OrderLimits limits;
            limits.highest = 7;
            const SeriesSource source(program, {});
            CHECK_MESSAGE(order_of_class(source, force_class("position_only"), limits).order == mine,
                          program.name);
            ++compared;
          }
        },
        reading.parts);
  }
  CHECK(compared >= 25);
}
