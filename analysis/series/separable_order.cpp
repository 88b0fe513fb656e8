// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/separable_order.hpp"

#include "analysis/series/splitting_reading.hpp"

namespace shortfall {

namespace {

constexpr int kPosition = 0;  // the component of q, whose derivative is f

/// The kicks and drifts of a step, or why there are none.
struct PartsFound {
  std::vector<SplittingPart<Fraction>> parts;
  std::string why_not;
};

PartsFound parts_of(const SeriesSource& source) {
  PartsFound found;
  const Program& program = source.program();
  if (program.splitting) {
    const std::vector<Fraction> weights = source.splitting_weights();
    for (std::size_t i = 0; i < weights.size(); ++i)
      found.parts.push_back({program.splitting->parts[i].kick, weights[i]});
    return found;
  }
  const std::string head = "an order for T(p) + V(q) is that of kicks and drifts or of a tableau; ";
  const SplittingReading reading = splitting_reading(program, source.values());
  const auto* rational = std::get_if<KicksAndDrifts<Rational>>(&reading.parts);
  if (!rational) {
    found.why_not = head + (reading.is_splitting() ? "this step is no splitting block" : reading.why_not);
    return found;
  }
  if (!merged(composed(rational->start, rational->finish)).empty()) {
    found.why_not = head + "the finish of this integrator does not undo its start";
    return found;
  }
  for (const SplittingPart<Rational>& p :
       composed(composed(rational->start, rational->step), rational->finish))
    found.parts.push_back({p.kick, Fraction(p.weight)});
  return found;
}

}  // namespace

const ForceClass& separable_forces() {
  static const ForceClass forces{"separable", "T(p) + V(q)", "separable Hamiltonians",
                                 Signature::separable()};
  return forces;
}

template <class K>
TreeSeries<K> separable_series(const TreeTable& table, const std::vector<SplittingPart<K>>& parts) {
  TreeSeries<K> state(table.size(), K(0)), slope(table.size(), K(0));
  for (const SplittingPart<K>& part : parts) {
    if (vanishes(part.weight)) continue;
    // f of p, or g of q: one factor for each branch, which belongs to the other component.
    for (TreeId t = 0; t < table.size(); ++t) {
      if ((table.component(t) == kPosition) == part.kick) continue;
      slope[t] = K(1);
      if (!table.is_node(t)) slope[t] = slope[table.left(t)] * state[table.right(t)];
      if (!vanishes(slope[t])) state[t] += part.weight * slope[t];
    }
  }
  return state;
}

template TreeSeries<Rational> separable_series(const TreeTable&, const std::vector<SplittingPart<Rational>>&);
template TreeSeries<Fraction> separable_series(const TreeTable&, const std::vector<SplittingPart<Fraction>>&);

SeparableOrder separable_order(const SeriesSource& source, const OrderLimits& limits) {
  SeparableOrder result;
  if (source.has_tableau()) {
    result.order = order_of_class(source, force_class("autonomous"), limits);
    result.order->forces = &separable_forces();
    return result;
  }
  const PartsFound found = parts_of(source);
  result.why_not = found.why_not;
  if (!found.why_not.empty()) return result;
  OrderOfClass& order = result.order.emplace();
  order.forces = &separable_forces();
  order.at_least = true;
  for (int n = 1; n <= limits.highest; ++n) {
    order.too_many = too_many_trees(separable_forces().signature, n, limits);
    if (!order.too_many.empty()) break;
    if (limits.progress) limits.progress("order for " + separable_forces().force, n, limits.highest);
    const TreeTable table(separable_forces().signature, n, limits.most_bytes);
    TreeSeries<Fraction> difference = separable_series(table, found.parts);
    const TreeSeries<Rational> exact = exact_flow<Rational>(table);
    for (TreeId t = table.begin(n); t < table.end(n); ++t) difference[t] -= Fraction(exact[t]);
    order.errors = terms_of_order(source, table, n, difference);
    if (!order.errors.empty()) {
      order.at_least = false;
      break;
    }
    order.order = n;
    order.conditions = static_cast<std::size_t>(table.size());
  }
  return result;
}

}  // namespace shortfall
