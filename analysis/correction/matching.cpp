// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/correction/matching.hpp"

#include <algorithm>

#include "analysis/algebra/error.hpp"

namespace shortfall {

namespace {

/// The value of a letter from an equation that is linear in it; empty when it is not.
std::optional<Fraction> solved_for(const Fraction& equation, Letter unknown) {
  if (equation.numerator().degree(unknown) != 1) return std::nullopt;
  return -Fraction(equation.numerator().coefficient(unknown, 0),
                   equation.numerator().coefficient(unknown, 1));
}

/// The linear factor in an unknown of an equation whose other factors do not vanish for all letters; several
/// linear factors are several solutions.
std::vector<Fraction> roots(const Fraction& equation, Letter unknown, int& highest) {
  std::vector<Fraction> found;
  highest = 0;
  for (const auto& [factor, multiplicity] : factor(equation.numerator()).factors) {
    const int degree = factor.degree(unknown);
    highest = std::max(highest, degree);
    if (degree == 1)
      found.push_back(-Fraction(factor.coefficient(unknown, 0), factor.coefficient(unknown, 1)));
  }
  return found;
}

bool all_zero(const std::vector<Fraction>& conditions, const Matching& m) {
  return std::ranges::all_of(conditions, [&](const Fraction& f) { return m.put_into(f).is_zero(); });
}

Matching one_unknown(const std::vector<Fraction>& conditions, Letter unknown,
                     const std::vector<std::string>& names) {
  Matching m{{unknown}, {}, false, {}};
  for (const Fraction& condition : conditions) {
    if (condition.is_zero()) continue;
    if (!condition.contains(unknown)) {
      m.impossible = true;
      m.obstruction = "no choice of " + names[unknown] + " changes the difference " + condition.str(names);
      return m;
    }
    int highest = 0;
    for (const Fraction& root : roots(condition, unknown, highest)) {
      m.values = std::vector<Fraction>{root};
      if (all_zero(conditions, m)) return m;
      m.values.reset();
    }
    m.obstruction = highest > 1
                        ? "the condition is an irreducible equation of degree " + std::to_string(highest) +
                              " in " + names[unknown] + ", whose roots are no rational functions of the flow"
                        : "the one value of " + names[unknown] + " that matches one of them misses the other";
    return m;
  }
  m.values = std::vector<Fraction>{Fraction()};
  return m;
}

}  // namespace

Fraction Matching::put_into(Fraction f) const {
  if (values)
    for (std::size_t i = 0; i < unknowns.size(); ++i) f = f.substitute(unknowns[i], (*values)[i]);
  return f;
}

Matching matching(const std::vector<Fraction>& conditions, const std::vector<Letter>& unknowns,
                  const std::vector<std::string>& names) {
  if (unknowns.size() == 1) return one_unknown(conditions, unknowns[0], names);
  Matching best{unknowns,
                {},
                false,
                "the two conditions are polynomials of higher degree in k~ and c~, which we do not solve"};
  // Eliminate one unknown by an equation that is linear in it, then solve the other equation for the second.
  for (const std::size_t eliminated : {std::size_t{1}, std::size_t{0}})
    for (const std::size_t by : {std::size_t{0}, std::size_t{1}}) {
      const Letter first = unknowns[eliminated];
      const Letter second = unknowns[1 - eliminated];
      const std::optional<Fraction> value = solved_for(conditions[by], first);
      if (!value) continue;
      const Fraction rest = conditions[1 - by].substitute(first, *value);
      const Matching inner = one_unknown({rest}, second, names);
      if (!inner.values) {
        best.obstruction = inner.obstruction;
        continue;
      }
      Matching m{unknowns, std::vector<Fraction>(2), false, {}};
      (*m.values)[1 - eliminated] = (*inner.values)[0];
      try {
        (*m.values)[eliminated] = inner.put_into(*value);
        if (all_zero(conditions, m)) return m;
      } catch (const Undefined&) {
        // The eliminated unknown has no value there.
      }
    }
  return best;
}

}  // namespace shortfall
