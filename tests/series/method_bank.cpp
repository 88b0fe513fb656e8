// SPDX-License-Identifier: GPL-3.0-or-later
// The orders that the published methods of tests/data/methods claim, and that
// tests/independent/order_conditions.py checks from the textbook, come out of the tree series too.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "analysis/program/tableau_file.hpp"
#include "analysis/series/order.hpp"

using namespace shortfall;

namespace {

std::vector<TableauFile> bank() {
  std::vector<TableauFile> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SHORTFALL_SOURCE_DIR) + "/tests/data/methods"))
    if (entry.path().extension() == ".json") files.push_back(parse_tableau_file(entry.path().string()));
  return files;
}

/// The order of y + h sum of weights_i f(stage i) for y' = f(y), up to `highest`.
int order(const ButcherTableau<Rational>& tableau, const std::vector<Rational>& weights, int highest) {
  const TreeTable table(Signature::first_order(), highest);
  const TreeSeries<Rational> result = ElementaryWeights<Rational>(tableau, table).result(weights);
  int order = highest;
  for (TreeId t = 0; t < table.size(); ++t)
    if (result[t] != Rational(1) / table.density(t)) order = std::min(order, table.order(t) - 1);
  return order;
}

}  // namespace

TEST_CASE("the exact methods of the bank have the orders they claim, embedded results too") {
  int methods = 0, embedded = 0;
  for (const TableauFile& file : bank()) {
    if (file.nystroem || !file.exact()) continue;
    const SeriesSource source(file.program, {});
    if (!source.rational()) continue;
    CAPTURE(file.name);
    const ButcherTableau<Rational> tableau = source.tableau<Rational>();
    CHECK(order(tableau, tableau.b, file.claims.order->value + 1) == file.claims.order->value);
    ++methods;
    if (!file.claims.embedded_order) continue;
    CHECK(order(tableau, tableau.embedded, file.claims.embedded_order->value + 1) ==
          file.claims.embedded_order->value);
    ++embedded;
  }
  CHECK(methods >= 60);
  CHECK(embedded >= 20);
}

TEST_CASE("for every force the methods of the bank have the order they claim, not more" *
          doctest::test_suite("thorough")) {
  for (const TableauFile& file : bank()) {
    if (file.claims.order->value > 6) continue;
    CAPTURE(file.name);
    const SeriesSource source(file.program, {});
    // A Nystroem method is for forces that do not read the velocity.
    const std::string forces_named = file.nystroem ? "velocity_independent" : "general";
    const ForceClass& forces = force_class(forces_named);
    OrderLimits limits;
    limits.highest = file.claims.order->value + 1;
    const OrderOfClass found = order_of_class(source, forces, limits);
    CHECK(found.order == file.claims.order->value);
    CHECK_FALSE(found.at_least);
  }
}
