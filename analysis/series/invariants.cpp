// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/invariants.hpp"

#include <algorithm>
#include <map>

#include "analysis/series/conjugation.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/free_trees.hpp"

namespace shortfall {

namespace {

using Verdict = Property::Verdict;
constexpr int kForce = FreeTrees::kForce, kDrift = FreeTrees::kDrift;

/// Pairs of roots of one free tree, and the sign with which their coefficients have to agree.
struct Condition {
  TreeId first, second;
  int sign;  ///< field[first] = sign * field[second]
};
std::vector<Condition> hamiltonian_conditions(const TreeTable& table, int order) {
  std::vector<Condition> conditions;
  FreeTrees free(table, order);
  for (TreeId t = table.begin(order); t < table.end(order); ++t) {
    if (table.function(t) == kForce && free.representative(t) != t)
      conditions.push_back({t, free.representative(t), 1});
    if (table.function(t) == kDrift)
      conditions.push_back({t, table.product(table.right(t), table.node(kDrift)), -1});
  }
  return conditions;
}

}  // namespace

Property energy_preserving(const SeriesSource& source, int order) {
  Property p;
  p.up_to = order;
  with_coefficients(source, [&]<class K>() {
    const TreeTable table(Signature::mechanical(false, false), order + 1);
    const TreeSeries<K> field = source.step<K>(table).field;
    const TreeId drift = table.node(kDrift), fall = table.product(drift, table.node(kForce));
    for (int n = 1; n <= order; ++n) {
      // v . F(tau) for v', V' . F(tau) for x': scalars of one node more.
      FreeTrees free(table, n + 1);
      std::map<TreeId, Fraction> sum;
      for (TreeId t = table.begin(n); t < table.end(n); ++t) {
        const bool force = table.function(t) == kForce;
        if (!force && table.is_node(t)) {
          // x' = v: V' v, which v' = a cancels.
          sum[free.representative(table.product(table.node(kForce), drift))] += Fraction(field[t]);
          continue;
        }
        const TreeId vector = force ? t : table.right(t);
        const TreeId scalar = table.product(vector, force ? drift : fall);
        const Fraction weight = Fraction(field[t]) / Fraction(table.symmetry(vector));
        sum[free.representative(scalar)] += forces_in(table, vector) % 2 == 0 ? weight : -weight;
      }
      for (const auto& [scalar, value] : sum)
        if (!source.zero(value)) {
          p.verdict = Verdict::refuted;
          p.up_to = n;
          p.how = "a step changes it by h^" + std::to_string(n);
          return;
        }
    }
  });
  return p;
}

Property conjugate_symplectic(const SeriesSource& source, int order) {
  Property p;
  p.up_to = order;
  with_coefficients(source, [&]<class K>() {
    const TreeTable table(Signature::mechanical(false, false), order);
    TreeSeries<K> field = source.step<K>(table).field;
    for (int n = 2; n <= order; ++n) {
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
      if (matrix.empty()) continue;
      const LinearSolution<K> found = solve_linear<K>(matrix, right);
      if (!found.solution) {
        p.verdict = Verdict::refuted;
        p.up_to = n;
        p.how = "no change of variables makes the terms of order h^" + std::to_string(n) +
                " of a step Hamiltonian";
        return;
      }
      TreeSeries<K> c(table.size(), K(0));
      for (std::size_t i = 0; i < system.unknowns().size(); ++i)
        c[system.unknowns()[i]] = (*found.solution)[i];
      field = conjugated(table, c, field);
    }
  });
  return p;
}

}  // namespace shortfall
