// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/hamiltonian.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"
#include "analysis/series/differential.hpp"
#include "analysis/series/free_trees.hpp"

namespace shortfall {

namespace {

/// The derivative of V that a node with so many children is, the root's own index counted or not.
std::string derivative(std::size_t by_space, std::size_t by_time, bool latex) {
  std::string text = "V";
  if (by_space <= 3)
    text += std::string(by_space, '\'');
  else
    text += (latex ? "^{(" : "^(") + std::to_string(by_space) + (latex ? ")}" : ")");
  if (by_time > 0) text += (latex ? "_{" : "_") + std::string(by_time, 't') + (latex ? "}" : "");
  return text;
}

struct Parts {
  std::vector<TreeId> space;
  std::size_t time = 0;
};

Parts parts(const TreeTable& table, TreeId t) {
  Parts p;
  std::vector<TreeId> children = table.children(t);
  std::ranges::reverse(children);
  for (TreeId c : children)
    if (table.component(c) == 2)
      ++p.time;
    else
      p.space.push_back(c);
  return p;
}

/// The vector that a child of a node is: v, or a gradient of V with the signs taken out.
std::string vector_text(const TreeTable& table, TreeId child, bool latex) {
  if (table.is_node(child)) return "v";
  const Parts p = parts(table, table.right(child));
  std::string text = derivative(p.space.size() + 1, p.time, latex);
  if (p.space.empty()) return text;
  if (p.space.size() == 1) return text + " " + vector_text(table, p.space[0], latex);
  text += "(";
  for (std::size_t i = 0; i < p.space.size(); ++i)
    text += (i > 0 ? ", " : "") + vector_text(table, p.space[i], latex);
  return text + ")";
}

}  // namespace

std::string contraction(const TreeTable& table, TreeId t, bool latex) {
  const Parts p = parts(table, t);
  std::string text = derivative(p.space.size(), p.time, latex);
  if (p.space.empty()) return text;
  if (p.space.size() == 1) return text + " " + vector_text(table, p.space[0], latex);
  text += "(";
  for (std::size_t i = 0; i < p.space.size(); ++i)
    text += (i > 0 ? ", " : "") + vector_text(table, p.space[i], latex);
  return text + ")";
}

namespace {

void count_factors(const TreeTable& table, TreeId t, bool root, std::vector<int>& factors) {
  const auto add = [&](std::size_t index) {
    if (factors.size() <= index) factors.resize(index + 1);
    ++factors[index];
  };
  const Parts p = parts(table, t);
  add(p.space.size() + (root ? 0 : 1));
  for (TreeId c : p.space)
    if (table.is_node(c))
      add(0);
    else
      count_factors(table, table.right(c), false, factors);
}

}  // namespace

template <class K>
ModifiedHamiltonian hamiltonian(const SeriesSource& source, const TreeTable& table,
                                const TreeSeries<K>& field) {
  ModifiedHamiltonian result;
  result.order = table.order();
  const TreeId drift = table.node(FreeTrees::kDrift);
  for (int n = 2; n <= table.order(); ++n) {
    FreeTrees free(table, n);
    const auto fails = [&](TreeId a, TreeId b, const Fraction& difference) {
      if (source.zero(difference)) return false;
      result.obstruction = "the coefficients of " + differential(table, a) + " (in " +
                           table.signature().components[table.component(a)] + "') and " +
                           differential(table, b) + " (in " +
                           table.signature().components[table.component(b)] +
                           "') do not belong to one Hamiltonian: " + tree_text(table, a) + " and " +
                           tree_text(table, b) + " are one free tree";
      result.obstructed_at = n - 1;
      return true;
    };
    for (TreeId t = table.begin(n); t < table.end(n); ++t) {
      if (table.function(t) == FreeTrees::kForce) {
        const TreeId r = free.representative(t);
        if (fails(r, t, Fraction(field[t]) - Fraction(field[r]))) return result;
      } else if (table.function(t) == FreeTrees::kDrift) {
        // Rooted at an end v: the coefficient has the other sign.
        const TreeId partner = table.product(table.right(t), drift);
        if (fails(partner, t, Fraction(field[t]) + Fraction(field[partner]))) return result;
      }
    }
    // One term for each free tree; the root with most children is the one that is written.
    for (TreeId r = table.begin(n); r < table.end(n); ++r) {
      if (table.function(r) != FreeTrees::kForce || free.representative(r) != r) continue;
      if (source.zero(Fraction(field[r]))) continue;  // zero as far as the digits of the method tell
      Rational roots;  // |Aut| times this is the number of forces: an orbit has |Aut| / sigma elements
      TreeId best = r;
      for (TreeId t = r; t < table.end(n); ++t) {
        if (table.function(t) != FreeTrees::kForce || free.representative(t) != r) continue;
        roots += Rational(1) / table.symmetry(t);
        if (table.children(t).size() > table.children(best).size()) best = t;
      }
      const int forces = forces_in(table, r);
      const Rational automorphisms = Rational(forces) / roots;
      Fraction coefficient = Fraction(field[r]) / Fraction(automorphisms);
      if (forces % 2 == 0) coefficient = -coefficient;
      EnergyTerm term{
          n - 1, contraction(table, best, false), contraction(table, best, true), {}, coefficient};
      if (table.signature().components.size() == 2) count_factors(table, best, true, term.in_one_dimension);
      result.terms.push_back(std::move(term));
    }
  }
  return result;
}

template ModifiedHamiltonian hamiltonian(const SeriesSource&, const TreeTable&, const TreeSeries<Rational>&);
template ModifiedHamiltonian hamiltonian(const SeriesSource&, const TreeTable&, const TreeSeries<Fraction>&);

ModifiedHamiltonian modified_hamiltonian(const SeriesSource& source, int order, const OrderLimits& limits) {
  const TreeTable table(Signature::mechanical(false, false), order, limits.most_bytes);
  return with_coefficients(
      source, [&]<class K>() { return hamiltonian<K>(source, table, source.step<K>(table).field); });
}

}  // namespace shortfall
