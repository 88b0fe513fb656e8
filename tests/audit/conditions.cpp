// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of Nystroem tableaus, held against what is known of kicks and drifts, and against trees.
#include "analysis/audit/conditions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "analysis/audit/structure.hpp"
#include "analysis/audit/tableau_audit.hpp"

using namespace shortfall;

namespace {

/// Kicks b_i behind drifts that have come to c_i, as a Nystroem tableau (Okunbor & Skeel 1992).
Method<Rational> nystroem(const std::vector<Rational>& kicks, const std::vector<Rational>& times) {
  const std::size_t stages = kicks.size();
  Method<Rational> m;
  m.nystroem = true;
  m.b = kicks;
  m.c = times;
  for (std::size_t i = 0; i < stages; ++i) {
    m.b_position.push_back(kicks[i] * (Rational(1) - times[i]));
    m.a.emplace_back(stages, Rational());
    for (std::size_t j = 0; j < i; ++j) m.a[i][j] = kicks[j] * (times[i] - times[j]);
  }
  return m;
}

bool hold(const Method<Rational>& m, bool symplectic) {
  Demands demands;
  demands.symplectic = symplectic;
  demands.symmetric = !symplectic;
  const Conditions conditions(demands, m.stages(), m.nystroem, 1e8);
  const auto defects = conditions.defects(m);
  return std::ranges::all_of(defects, [](const Rational& r) { return r.is_zero(); });
}

}  // namespace

TEST_CASE(
    "kicks and drifts are symplectic as Nystroem tableaus; palindromes are symmetric, by equations and by "
    "trees") {
  std::mt19937 random(11);
  const auto number = [&] {
    return Rational(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 6));
  };
  constexpr int kTreeOrder = 6;
  int asymmetric = 0;
  for (int n = 0; n < 40; ++n) {
    const Rational k = number(), c = number(), middle = Rational(1) - Rational(2) * k;
    const Method<Rational> palindrome = nystroem({k, middle, k}, {c, Rational(1, 2), Rational(1) - c});
    CHECK(hold(palindrome, true));
    CHECK(hold(palindrome, false));
    CHECK_FALSE(not_symmetric(palindrome, kTreeOrder));
    const Method<Rational> any = nystroem({number(), number(), number()}, {number(), number(), number()});
    CHECK(hold(any, true));
    // What the equations say of symmetry, trees say too, for weights that do not vanish.
    const bool irreducible = std::ranges::none_of(any.b, [](const Rational& b) { return b.is_zero(); });
    if (irreducible && !hold(any, false)) asymmetric += not_symmetric(any, kTreeOrder).has_value();
    Method<Rational> wrong = palindrome;
    wrong.b_position[1] += Rational(1, 7);
    CHECK_FALSE(hold(wrong, true));
    CHECK_FALSE(hold(wrong, false));
    CHECK(not_symmetric(wrong, kTreeOrder));
  }
  CHECK(asymmetric >= 20);
}

TEST_CASE("Gauss' methods are symplectic and symmetric, Radau's neither, by equations and by trees") {
  const Rational third(1, 3);
  Method<Rational> radau;
  radau.a = {{Rational(5, 12), Rational(-1, 12)}, {Rational(3, 4), Rational(1, 4)}};
  radau.b = {Rational(3, 4), Rational(1, 4)};
  radau.c = {third, Rational(1)};
  CHECK_FALSE(hold(radau, true));
  CHECK_FALSE(hold(radau, false));
  CHECK(not_symplectic(radau, 8));
  CHECK(not_symmetric(radau, 8));
  Method<Rational> midpoint;
  midpoint.a = {{Rational(1, 2)}};
  midpoint.b = {Rational(1)};
  midpoint.c = {Rational(1, 2)};
  CHECK(hold(midpoint, true));
  CHECK(hold(midpoint, false));
  CHECK_FALSE(not_symplectic(midpoint, 8));
  CHECK_FALSE(not_symmetric(midpoint, 8));
}

TEST_CASE("a method that repeats a stage is not called asymmetric for it") {
  // The midpoint rule with its stage written twice, unevenly weighted: the equations for the entries fail.
  const Audit audit = audit_tableau(parse_tableau(
      R"({"A": [["1/4", "1/4"], ["1/4", "1/4"]], "b": ["1/3", "2/3"], "c": ["1/2", "1/2"], "order": 2,
          "symmetric": true, "symplectic": true})",
      "twice.json"));
  CHECK_FALSE(audit.refuted());
  CHECK(audit.undecided());
}
