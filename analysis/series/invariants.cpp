// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/invariants.hpp"

#include <algorithm>
#include <map>

#include "analysis/series/conjugation.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/free_trees.hpp"
#include "analysis/series/hamiltonian.hpp"

namespace shortfall {

namespace {

using Verdict = Property::Verdict;

/// Pairs of roots of one free tree, and the sign with which their coefficients have to agree.
struct Condition {
  TreeId first, second;
  int sign;  ///< field[first] = sign * field[second]
};
std::vector<Condition> hamiltonian_conditions(const TreeTable& table, int order) {
  std::vector<Condition> conditions;
  FreeTrees free(table, order);
  for (TreeId t = table.begin(order); t < table.end(order); ++t) {
    if (table.function(t) == FreeTrees::kForce && free.representative(t) != t)
      conditions.push_back({t, free.representative(t), 1});
    if (table.function(t) == FreeTrees::kDrift)
      conditions.push_back({t, table.product(table.right(t), table.node(FreeTrees::kDrift)), -1});
  }
  return conditions;
}

/// How many fields of an order are Hamiltonian, up to a factor: one for each free tree.
std::size_t hamiltonian_fields(const TreeTable& table, int order) {
  if (order == 1) return 2;  // the force by itself, and the drift
  FreeTrees free(table, order);
  std::size_t count = 0;
  for (TreeId t = table.begin(order); t < table.end(order); ++t)
    if (table.function(t) == FreeTrees::kForce && free.representative(t) == t) ++count;
  return count;
}

}  // namespace

EnergyChange energy_change(const SeriesSource& source, int highest) {
  EnergyChange result;
  for (int n = 2; n <= highest; ++n) {
    result.looked_at = n;
    // With the energy's own V' or v a tree has one node more.
    const TreeTable table(Signature::mechanical(false, false), n + 1);
    with_coefficients(source, [&]<class K>() {
      const TreeSeries<K> field = source.step<K>(table).field;
      FreeTrees free(table, n + 1);
      std::map<TreeId, K> sums;
      const TreeId v = table.node(FreeTrees::kDrift), a = table.product(v, table.node(FreeTrees::kForce));
      for (TreeId t = table.begin(n); t < table.end(n); ++t) {
        if (vanishes(field[t])) continue;
        // v' times v, and x' times V' = -a.
        const bool force = table.function(t) == FreeTrees::kForce;
        const TreeId whole = table.product(force ? t : table.right(t), force ? v : a);
        const K weight = field[t] / K(table.symmetry(t));
        sums[free.representative(whole)] += force ? weight : K(0) - weight;
      }
      for (const auto& [tree, sum] : sums) {
        if (source.zero(Fraction(sum))) continue;
        // Written from the root with most children; every force is -V'.
        TreeId widest = tree;
        for (TreeId t = tree; t < table.end(n + 1); ++t)
          if (table.function(t) == FreeTrees::kForce && free.representative(t) == tree &&
              table.children(t).size() > table.children(widest).size())
            widest = t;
        result.terms.push_back(
            {contraction(table, widest), forces_in(table, tree) % 2 == 0 ? Fraction(sum) : -Fraction(sum)});
      }
    });
    if (result.terms.empty()) continue;
    result.order = n;
    break;
  }
  return result;
}

Property energy_preserving(const SeriesSource& source, int order) {
  const EnergyChange change = energy_change(source, order);
  if (change.order == 0) return {Verdict::not_contradicted, order, ""};
  return {Verdict::refuted, change.order, "a step changes it by h^" + std::to_string(change.order)};
}

template <class K>
Property conjugate_symplectic(const SeriesSource& source, const TreeTable& table, TreeSeries<K> field) {
  Property p;
  for (int n = 2; n <= table.order(); ++n) {
    const Conjugation system(table, n, {});
    std::map<TreeId, std::size_t> row;
    for (std::size_t i = 0; i < system.equations().size(); ++i) row[system.equations()[i]] = i;
    // Conditions on L_n + [c, F].
    std::vector<std::vector<K>> matrix;
    std::vector<K> right;
    for (const Condition& c : hamiltonian_conditions(table, n)) {
      const std::vector<int>&a = system.matrix()[row.at(c.first)], &b = system.matrix()[row.at(c.second)];
      matrix.emplace_back();
      for (std::size_t i = 0; i < system.unknowns().size(); ++i)
        matrix.back().push_back(K(a[i] - c.sign * b[i]));
      const K difference = field[c.first] - K(c.sign) * field[c.second];
      right.push_back(source.zero(Fraction(difference)) ? K(0) : K(0) - difference);
    }
    const LinearSolution<K> found = solve_linear<K>(matrix, right);
    if (!found.solution) {
      p.verdict = Verdict::refuted;
      p.up_to = n;
      p.how =
          "no change of variables makes the terms of order h^" + std::to_string(n) + " of a step Hamiltonian";
      return p;
    }
    p.up_to = n;
    // Another choice might matter later: what follows would be no proof.
    if (found.free_unknowns.size() > hamiltonian_fields(table, n - 1)) return p;
    TreeSeries<K> c(table.size(), K(0));
    for (std::size_t i = 0; i < system.unknowns().size(); ++i) c[system.unknowns()[i]] = (*found.solution)[i];
    field = conjugated(table, c, field);
  }
  return p;
}

template Property conjugate_symplectic(const SeriesSource&, const TreeTable&, TreeSeries<Rational>);
template Property conjugate_symplectic(const SeriesSource&, const TreeTable&, TreeSeries<Fraction>);

Property conjugate_symplectic(const SeriesSource& source, int order) {
  const TreeTable table(Signature::mechanical(false, false), order);
  return with_coefficients(
      source, [&]<class K>() { return conjugate_symplectic<K>(source, table, source.step<K>(table).field); });
}

}  // namespace shortfall
