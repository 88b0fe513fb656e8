// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/modified.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/modifying.hpp"

namespace shortfall {

namespace {

ModifiedEquation about(const SeriesSource& source, const ForceClass* forces, int order) {
  ModifiedEquation m;
  m.integrator = source.program().name;
  m.forces = forces;
  m.order = order;
  m.digits = source.digits();
  m.notes = source.notes();
  return m;
}

TreeTable table_for(const SeriesSource& source, const ForceClass* forces, int order,
                    const OrderLimits& limits) {
  if (!forces && !source.has_tableau())
    throw Unable(source.program().name +
                 " is not written as a tableau: its step is one for x'' = a(x, v, t)");
  return {forces ? forces->signature : Signature::first_order(), order, limits.most_bytes};
}

template <class K>
void put_terms(const SeriesSource& source, const TreeTable& table, const TreeSeries<K>& field,
               ModifiedEquation& m) {
  Fraction sum;
  m.trees = static_cast<std::size_t>(table.size());
  for (TreeId t = 0; t < table.size(); ++t) {
    if (vanishes(field[t])) continue;
    const std::string& component = table.signature().components[table.component(t)];
    if (component == "t") continue;
    const Fraction& b = field[t];
    sum += b;
    if (source.zero(b)) continue;
    m.terms.push_back({component, table.order(t) - 1, tree_text(table, t), differential(table, t),
                       differential(table, t, true), b / Fraction(table.symmetry(t))});
  }
  m.checksum = sum;
}

/// The force with which a step that is no tableau is exact: each tree with the force at the root is chosen
/// so that the velocity is right; then the position is right too, or no force makes both so.
template <class K>
TreeSeries<K> modifying_force(const SeriesSource& source, const TreeTable& table, std::string& obstruction) {
  const TreeSeries<K> exact = exact_flow<K>(table);
  TreeSeries<K> force(table.size(), K(0));
  for (int n = 1; n <= table.order(); ++n) {
    const OneStep<K> step = source.step<K>(table, &force);
    for (TreeId t = table.begin(n); t < table.end(n); ++t) {
      const K difference = exact[t] - step.map[t];
      if (table.function(t) == 0) {
        force[t] = difference;
      } else if (!source.zero(Fraction(difference))) {
        obstruction = "the error of x in h^" + std::to_string(n) + " " + differential(table, t) + " is " +
                      source.decimal(Fraction(K(0) - difference) / Fraction(table.symmetry(t)), 6) +
                      ", and the force that would remove it is already chosen by the condition on v";
        return force;
      }
    }
  }
  return force;
}

}  // namespace

ModifiedEquation modified_equation(const SeriesSource& source, const ForceClass* forces, int order,
                                   const OrderLimits& limits) {
  ModifiedEquation m = about(source, forces, order);
  const TreeTable table = table_for(source, forces, order, limits);
  with_coefficients(source, [&]<class K>() { put_terms<K>(source, table, source.step<K>(table).field, m); });
  return m;
}

ModifiedEquation modifying_equation(const SeriesSource& source, const ForceClass* forces, int order,
                                    const OrderLimits& limits) {
  ModifiedEquation m = about(source, forces, order);
  m.modifying = true;
  const TreeTable table = table_for(source, forces, order, limits);
  with_coefficients(source, [&]<class K>() {
    if (!forces) {
      const ButcherTableau<K> tableau = source.tableau<K>();
      K weight(0);
      for (const K& b : tableau.b) weight += b;
      if (!source.zero(Fraction(weight) - Fraction(1)))
        throw Undefined("the weights b do not add up to 1: the method is not consistent");
      put_terms<K>(source, table, modifying_field<K>(tableau, table), m);
    } else {
      put_terms<K>(source, table, modifying_force<K>(source, table, m.obstruction), m);
    }
  });
  if (!m.obstruction.empty()) m.terms.clear();
  return m;
}

}  // namespace shortfall
