// SPDX-License-Identifier: GPL-3.0-or-later
// Orders for T(p) + V(q) by trees, against the free Lie algebra and against what is seen at 60 digits.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "analysis/algebra/real.hpp"
#include "analysis/program/catalogue.hpp"
#include "analysis/series/separable_order.hpp"
#include "analysis/series/splitting_reading.hpp"
#include "tests/series/random_splitting.hpp"
#include "tests/series/sixty_digits.hpp"

using namespace shortfall;
using testing::kDigits, testing::sixty_digits;

namespace {

constexpr int kHighest = 7;

/// The last degree up to which the logarithm of the step is A + B.
template <class Field>
int order_by_brackets(const SplittingParts<Field>& parts) {
  const LieElement<Field> error =
      splitting_logarithm(parts, kHighest) - LieElement<Field>::a(kHighest) - LieElement<Field>::b(kHighest);
  for (int d = 1; d <= kHighest; ++d)
    for (const Field& c : error.part(d))
      if (!zero_as_known(c)) return d - 1;
  return kHighest;
}

int order_by_trees(const SplittingParts<Rational>& parts) {
  const TreeTable table(Signature::separable(), kHighest);
  const TreeSeries<Rational> step = separable_series<Rational>(table, parts),
                             exact = exact_flow<Rational>(table);
  for (TreeId t = 0; t < table.size(); ++t)
    if (step[t] != exact[t]) return table.order(t) - 1;
  return kHighest;
}

Real digits(const std::string& decimal) { return Real(decimal); }

/// Where q' = p + p^3/3, p' = -q + q^2/3 - q^3/2 arrives at time 1/2.
std::pair<Real, Real> arrived(const std::vector<std::pair<bool, Real>>& parts, int steps) {
  const Real h = sixty_digits(Rational(1, 2 * steps));
  Real q = sixty_digits(Rational(5, 4)), p = sixty_digits(Rational(-1, 3));
  for (int n = 0; n < steps; ++n)
    for (const auto& [kick, weight] : parts)
      if (kick)
        p += Real(weight * h * Real(-q + q * q / 3 - q * q * q / 2));
      else
        q += Real(weight * h * Real(p + p * p * p / 3));
  return {q, p};
}

double observed(const std::vector<std::pair<bool, Real>>& parts, int steps) {
  const auto a = arrived(parts, steps), b = arrived(parts, 2 * steps), c = arrived(parts, 4 * steps);
  const auto size = [](const auto& x, const auto& y) {
    return Real(abs(Real(x.first - y.first)) + abs(Real(x.second - y.second)));
  };
  return std::log2(static_cast<double>(Real(size(a, b) / size(b, c))));
}

}  // namespace

TEST_CASE("orders for T(p) + V(q) are those of the brackets of A and B, for the whole catalogue") {
  int compared = 0;
  for (const Program& program : catalogue()) {
    const SeriesSource source(program, {});
    const SplittingReading reading = splitting_reading(program, source.values());
    const SeparableOrder trees = separable_order(source);
    if (source.has_tableau()) {
      CHECK(trees.order->order == order_of_class(source, force_class("autonomous")).order);
      continue;
    }
    if (!trees.order) {
      CHECK(!trees.why_not.empty());
      continue;
    }
    CAPTURE(program.name);
    std::visit(
        [&](const auto& parts) {
          if constexpr (requires { parts.step; }) {
            CHECK(trees.order->order ==
                  order_by_brackets(composed(composed(parts.start, parts.step), parts.finish)));
            ++compared;
          } else {
            FAIL("kicks and drifts without a reading");
          }
        },
        reading.parts);
  }
  CHECK(compared >= 30);
}

TEST_CASE("and for random splittings") {
  CHECK(rc::check([] {
    const auto parts = *random::consistent_splitting(5);
    RC_ASSERT(order_by_trees(parts) == order_by_brackets(parts));
  }));
}

TEST_CASE(
    "the order for T(p) + V(q) is the order seen at 60 digits; Nystroem splittings lose some of theirs") {
  const Precision precision(kDigits);
  int lost = 0;
  for (const Program& program : catalogue()) {
    if (!program.splitting) continue;
    CAPTURE(program.name);
    const SeriesSource source(program, {});
    std::vector<std::pair<bool, Real>> parts;
    const std::vector<Fraction> weights = source.splitting_weights();
    for (std::size_t i = 0; i < weights.size(); ++i)
      parts.emplace_back(program.splitting->parts[i].kick, digits(source.decimal(weights[i], kDigits)));
    const int order = separable_order(source).order->order;
    const double seen = observed(parts, order < 4 ? 60 : 24);
    CAPTURE(seen);
    CHECK(std::abs(seen - order) < 0.25);
    lost += order < order_of_class(source, force_class("velocity_independent")).order;
  }
  // Of McLachlan & Atela's and Blanes & Moan's RKN methods those of orders 4 and 6.
  CHECK(lost == 3);
}

TEST_CASE(
    "an integrator that is neither kicks and drifts nor a tableau has no order for T(p) + V(q), and says "
    "why") {
  const SeparableOrder found = separable_order(SeriesSource(find_integrator("beeman"), {}));
  CHECK(!found.order);
  CHECK(found.why_not.find("kicks and drifts") != std::string::npos);
}
