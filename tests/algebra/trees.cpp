// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/algebra/trees.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "analysis/algebra/error.hpp"
#include "analysis/algebra/tree_series.hpp"

using namespace shortfall;

namespace {

/// How many trees of each order have this function at the root (any, for -1).
std::vector<int> counted(const Signature& signature, int orders, int function) {
  const TreeTable table(signature, orders);
  std::vector<int> result(static_cast<std::size_t>(orders));
  for (TreeId t = 0; t < table.size(); ++t)
    if (function < 0 || table.function(t) == function) ++result[static_cast<std::size_t>(table.order(t)) - 1];
  return result;
}

const std::vector<Signature>& signatures() {
  static const std::vector<Signature> all{
      Signature::first_order(), Signature::first_order_with_time(),  Signature::additive(),
      Signature::separable(),   Signature::mechanical(false, false), Signature::mechanical(true, true)};
  return all;
}

/// A tree as nested lists of functions, written out: the sorted children in brackets.
std::string written(const TreeTable& table, TreeId t) {
  std::vector<std::string> children;
  for (TreeId c : table.children(t)) children.push_back(written(table, c));
  std::ranges::sort(children);
  std::string text = std::to_string(table.function(t)) + "[";
  for (const std::string& c : children) text += c;
  return text + "]";
}

/// A tree as parents of numbered nodes.
struct Numbered {
  std::vector<int> parent, function;
};
int number(const TreeTable& table, TreeId t, int parent, Numbered& n) {
  const int own = static_cast<int>(n.parent.size());
  n.parent.push_back(parent);
  n.function.push_back(table.function(t));
  for (TreeId c : table.children(t)) number(table, c, own, n);
  return own;
}
std::string written(const Numbered& n, int node, int without = -1) {
  std::vector<std::string> children;
  for (int c = 0; c < static_cast<int>(n.parent.size()); ++c)
    if (n.parent[static_cast<std::size_t>(c)] == node && c != without)
      children.push_back(written(n, c, without));
  std::ranges::sort(children);
  std::string text = std::to_string(n.function[static_cast<std::size_t>(node)]) + "[";
  for (const std::string& c : children) text += c;
  return text + "]";
}

/// Permutations of the nodes that leave the root, the parents and the functions as they are.
int automorphisms(const Numbered& n) {
  std::vector<int> p(n.parent.size());
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = static_cast<int>(i);
  int count = 0;
  do {
    bool same = p[0] == 0;
    for (std::size_t i = 1; i < p.size() && same; ++i)
      same = n.function[i] == n.function[static_cast<std::size_t>(p[i])] &&
             n.parent[static_cast<std::size_t>(p[i])] == p[static_cast<std::size_t>(n.parent[i])];
    count += same;
  } while (std::next_permutation(p.begin() + 1, p.end()));
  return count;
}

struct Random {
  std::mt19937 generator{23};
  TreeSeries<Rational> operator()(const TreeTable& table) {
    TreeSeries<Rational> s;
    for (TreeId t = 0; t < table.size(); ++t)
      s.emplace_back(std::uniform_int_distribution<int>(-6, 6)(generator),
                     std::uniform_int_distribution<int>(1, 4)(generator));
    return s;
  }
};

}  // namespace

TEST_CASE("there are as many trees as the literature counts") {
  // OEIS A000081; Hairer, Norsett & Wanner (1993), II.2 and II.14.
  CHECK(counted(Signature::first_order(), 12, -1) ==
        std::vector<int>{1, 1, 2, 4, 9, 20, 48, 115, 286, 719, 1842, 4766});
  CHECK(counted(Signature::additive(), 7, -1) == std::vector<int>{2, 4, 14, 52, 214, 916, 4116});
  CHECK(counted(Signature::mechanical(false, false), 12, 0) ==
        std::vector<int>{1, 1, 2, 3, 6, 10, 20, 36, 72, 137, 275, 541});
  CHECK(counted(Signature::mechanical(true, false), 8, 0) ==
        std::vector<int>{1, 2, 6, 18, 60, 204, 730, 2664});
  // With the position at the root: one, then the same list shifted by one.
  CHECK(counted(Signature::mechanical(true, false), 8, 1) == std::vector<int>{1, 1, 2, 6, 18, 60, 204, 730});
}

TEST_CASE("trees are counted without making them") {
  for (const Signature& s : signatures())
    for (int f = 0; f < static_cast<int>(s.functions.size()); ++f) {
      const std::vector<Rational> without = tree_counts(s, f, 6);
      const std::vector<int> made = counted(s, 6, f);
      for (int n = 1; n <= 6; ++n)
        CHECK(without[static_cast<std::size_t>(n)] == Rational(made[static_cast<std::size_t>(n) - 1]));
    }
}

TEST_CASE("no tree is made twice, and products find the tree whatever the order in which children are hung") {
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 6);
    std::set<std::string> seen;
    for (TreeId t = 0; t < table.size(); ++t) {
      CHECK(seen.insert(written(table, t)).second);
      std::vector<TreeId> children = table.children(t);
      std::ranges::sort(children);
      do {
        TreeId made = table.node(table.function(t));
        for (TreeId c : children) made = table.product(made, c);
        CHECK(made == t);
      } while (std::ranges::next_permutation(children).found);
    }
  }
}

TEST_CASE("symmetries are counted right, by trying all permutations of the nodes") {
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 5);
    for (TreeId t = 0; t < table.size(); ++t) {
      Numbered n;
      number(table, t, -1, n);
      CHECK(table.symmetry(t) == Rational(automorphisms(n)));
    }
  }
}

TEST_CASE("densities are products of the sizes of all subtrees") {
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 6);
    for (TreeId t = 0; t < table.size(); ++t) {
      Numbered n;
      number(table, t, -1, n);
      // Parents have smaller numbers than their children.
      std::vector<int> sizes(n.parent.size(), 1);
      for (std::size_t i = n.parent.size(); --i > 0;)
        sizes[static_cast<std::size_t>(n.parent[i])] += sizes[i];
      Rational product(1);
      for (const int size : sizes) product *= Rational(size);
      CHECK(table.density(t) == product);
    }
  }
}

TEST_CASE("the exact flow by Picard's iteration is 1/gamma, one order a round") {
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 6);
    TreeSeries<Rational> y(table.size());
    for (int round = 1; round <= table.order(); ++round) {
      // The integral of h^(|t| - 1) times what f makes of y: one factor for each branch.
      TreeSeries<Rational> next(table.size());
      for (TreeId t = 0; t < table.size(); ++t) {
        Rational slope(1);
        for (TreeId c : table.children(t)) slope *= y[static_cast<std::size_t>(c)];
        next[static_cast<std::size_t>(t)] = slope / Rational(table.order(t));
      }
      y = next;
      const TreeSeries<Rational> exact = exact_flow<Rational>(table);
      for (TreeId t = 0; t < table.end(round); ++t) CHECK(y[t] == exact[t]);
      if (round < table.order()) CHECK(y != exact);
    }
    const TreeSeries<Rational> exact = exact_flow<Rational>(table);
    for (TreeId t = 0; t < table.size(); ++t) CHECK(exact[t] * table.density(t) == Rational(1));
  }
}

TEST_CASE("edges are cut as on paper") {
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 6);
    for (TreeId t = 0; t < table.size(); ++t) {
      Numbered n;
      number(table, t, -1, n);
      std::map<std::pair<std::string, std::string>, int> expected, found;
      for (int edge = 1; edge < static_cast<int>(n.parent.size()); ++edge)
        ++expected[{written(n, 0, edge), written(n, edge)}];
      for (const TreeTable::Split& split : table.splits(t))
        found[{written(table, split.trunk), written(table, split.branch)}] += split.count;
      CHECK(found == expected);
    }
  }
}

TEST_CASE("sums over all trees: n! in as many ways as trees grow node by node") {
  // The number of monotonic labellings, n! / (sigma gamma), adds up to (n - 1)!.
  const TreeTable table(Signature::first_order(), 9);
  for (int n = 1; n <= 9; ++n) {
    Rational sum;
    for (TreeId t = table.begin(n); t < table.end(n); ++t)
      sum += factorial(n) / (table.symmetry(t) * table.density(t));
    CHECK(sum == factorial(n - 1));
  }
}

TEST_CASE("flows, logarithms, compositions and inverses of random series fit together") {
  Random random;
  for (const Signature& s : signatures()) {
    const TreeTable table(s, 5);
    const TreeSeries<Rational> a = random(table), b = random(table), c = random(table);
    CHECK(logarithm(table, exponential(table, a)) == a);
    CHECK(exponential(table, logarithm(table, a)) == a);
    CHECK(composition(table, composition(table, a, b), c) == composition(table, a, composition(table, b, c)));
    CHECK(composition(table, a, inverse(table, a)) == TreeSeries<Rational>(table.size()));
    CHECK(adjoint(table, adjoint(table, a)) == a);
    // Jacobi's identity.
    const auto bracket = [&](const auto& p, const auto& q) { return commutator(table, p, q); };
    const auto one = bracket(a, bracket(b, c)), two = bracket(b, bracket(c, a)),
               three = bracket(c, bracket(a, b));
    for (TreeId t = 0; t < table.size(); ++t) CHECK((one[t] + two[t] + three[t]).is_zero());
    // The exact flow is that of the equation, and twice half of it is all of it.
    const TreeSeries<Rational> f = the_equation<Rational>(table), flow = exact_flow<Rational>(table);
    CHECK(exponential(table, f) == flow);
    CHECK(adjoint(table, flow) == flow);
    TreeSeries<Rational> half = f;
    for (Rational& value : half) value /= Rational(2);
    CHECK(composition(table, exponential(table, half), exponential(table, half)) == flow);
  }
}

TEST_CASE("a table that would not fit is refused before it is made, with what would") {
  CHECK_THROWS_AS(TreeTable(Signature::mechanical(true, true), 40), Unable);
  CHECK_THROWS_AS(TreeTable(Signature::first_order(), 1000), Unable);
  int fits = 1;
  while (TreeTable::bytes_needed(Signature::first_order(), fits + 1) <= 1e6) ++fits;
  try {
    const TreeTable refused(Signature::first_order(), 30, 1e6);
    FAIL("it was made");
  } catch (const Unable& e) {
    CHECK(std::string(e.what()).find("ask for order " + std::to_string(fits) + " or less") !=
          std::string::npos);
  }
  CHECK(TreeTable(Signature::first_order(), 12).bytes() <
        TreeTable::bytes_needed(Signature::first_order(), 12));
}
