// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/series/structure.hpp"

#include <algorithm>
#include <span>

#include "analysis/series/differential.hpp"
#include "analysis/series/hamiltonian.hpp"
#include "analysis/series/invariants.hpp"
#include "analysis/series/order.hpp"
#include "analysis/series/splitting_reading.hpp"

namespace shortfall {

namespace {

using Verdict = Property::Verdict;
// Trees that are looked at, a few first. A step of order p can hide what fails until order p + 2.
constexpr int kGeneral[] = {4};           // a(x, v, t): many trees
constexpr int kOthers[] = {4, 6, 8, 10};  // a(x), a(x, t), y' = f(y)
constexpr int kHighestStage = 20;

bool same_weights(const SeriesSource& source, const std::vector<Fraction>& differences) {
  return std::ranges::all_of(differences, [&](const Fraction& f) { return source.zero(f); });
}

/// Reflected, the tableau is itself: a_{s+1-i, s+1-j} + a_ij = b_j, b and c palindromes.
bool reflects(const SeriesSource& source, const ButcherTableau<Fraction>& t) {
  const std::size_t s = t.stages();
  std::vector<Fraction> differences;
  for (std::size_t i = 0; i < s; ++i) {
    differences.push_back(t.b[i] - t.b[s - 1 - i]);
    differences.push_back(t.c[i] + t.c[s - 1 - i] - Fraction(1));
    for (std::size_t j = 0; j < s; ++j) differences.push_back(t.a[s - 1 - i][s - 1 - j] + t.a[i][j] - t.b[j]);
  }
  return same_weights(source, differences);
}

/// b_i a_ij + b_j a_ji = b_i b_j.
bool keeps_quadratic_invariants(const SeriesSource& source, const ButcherTableau<Fraction>& t) {
  std::vector<Fraction> differences;
  for (std::size_t i = 0; i < t.stages(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      differences.push_back(t.b[i] * t.a[i][j] + t.b[j] * t.a[j][i] - t.b[i] * t.b[j]);
  return same_weights(source, differences);
}

/// Of kicks and drifts.
struct SplittingSymmetry {
  bool is_splitting = false;
  bool time_follows_drifts = false;
  bool palindrome = false;
  bool conjugate = false;  ///< start and finish undo each other, or are not there
};

SplittingSymmetry splitting_symmetry(const Program& program, const Values& given) {
  SplittingSymmetry found;
  const SplittingReading reading = splitting_reading(program, given);
  found.is_splitting = reading.is_splitting();
  std::visit(
      [&](const auto& parts) {
        if constexpr (requires { parts.step; }) {
          found.conjugate = merged(composed(parts.start, parts.finish)).empty();
          if (!found.conjugate) return;
          // As it is reported: start, step, and the finish that undoes the start.
          const auto whole = composed(composed(parts.start, parts.step), parts.finish);
          const auto step = merged(whole), back = merged(adjoint(whole));
          found.palindrome = std::ranges::equal(step, back, [](const auto& a, const auto& b) {
            return a.kick == b.kick && zero_as_known(a.weight - b.weight);
          });
          found.time_follows_drifts = parts.time_follows_drifts;
        }
      },
      reading.parts);
  return found;
}

/// The first tree of the step and of its adjoint that differ.
Property symmetric_per_tree(const SeriesSource& source, const Signature& signature,
                            std::span<const int> orders) {
  Property p;
  for (const int order : orders) {
    p.up_to = order;
    with_coefficients(source, [&]<class K>() {
      const TreeTable table(signature, order);
      const TreeSeries<K> map = source.step<K>(table).map, back = adjoint(table, map);
      for (TreeId t = 0; t < table.size(); ++t)
        if (!source.zero(Fraction(map[t] - back[t]))) {
          p.verdict = Verdict::refuted;
          p.up_to = table.order(t);
          p.how = "step and adjoint differ in h^" + std::to_string(table.order(t)) + " " +
                  differential(table, t) + " of " + table.signature().components[table.component(t)];
          return;
        }
    });
    if (!p.holds()) break;
  }
  return p;
}

Property symmetric(const SeriesSource& source, const SplittingSymmetry& parts) {
  const bool exact = source.digits() == 0;
  if (source.has_tableau()) {
    if (reflects(source, source.tableau<Fraction>()))
      return {exact ? Verdict::proved : Verdict::not_contradicted, 0, "its tableau is its own reflection"};
    return symmetric_per_tree(source, Signature::first_order(), kOthers);
  }
  Property general = symmetric_per_tree(source, force_class("general").signature, kGeneral);
  if (general.holds()) return general;
  // Most kicks are given a velocity of another moment: for forces that do not read it more may hold.
  if (parts.palindrome && parts.time_follows_drifts)
    return {exact ? Verdict::proved : Verdict::not_contradicted, 0,
            "for forces a(x, t): a palindrome of kicks and drifts"};
  Property still =
      symmetric_per_tree(source, force_class("velocity_independent").signature, std::span(kOthers).first(2));
  if (still.holds()) still.how = "for forces a(x, t)";
  return still;
}

Property symplectic(const SeriesSource& source, const SplittingSymmetry& parts) {
  const Verdict yes = source.digits() == 0 ? Verdict::proved : Verdict::not_contradicted;
  if (source.has_tableau() && keeps_quadratic_invariants(source, source.tableau<Fraction>()))
    return {yes, 0, "b_i a_ij + b_j a_ji = b_i b_j"};
  if (parts.is_splitting && parts.conjugate) return {yes, 0, "kicks and drifts keep the area each"};
  for (const int order : kOthers)
    if (const ModifiedHamiltonian h = modified_hamiltonian(source, order); !h.exists())
      return {Verdict::refuted, h.obstructed_at + 1, h.obstruction};
  return {Verdict::not_contradicted, kOthers[std::size(kOthers) - 1], ""};
}

/// C(q): sum over j of a_ij c_j^(k-1) = c_i^k / k for k up to q.
int stage_order(const SeriesSource& source, const ButcherTableau<Fraction>& t) {
  std::vector<Fraction> power(t.stages(), Fraction(1));  // c^(k-1)
  for (int k = 1; k <= kHighestStage; ++k) {
    for (std::size_t i = 0; i < t.stages(); ++i) {
      Fraction sum;
      for (std::size_t j = 0; j < t.stages(); ++j) sum += t.a[i][j] * power[j];
      if (!source.zero(sum - power[i] * t.c[i] / Fraction(k))) return k - 1;
    }
    for (std::size_t i = 0; i < t.stages(); ++i) power[i] *= t.c[i];
  }
  return kHighestStage;
}

bool has_row_sums(const SeriesSource& source, const ButcherTableau<Fraction>& t) {
  std::vector<Fraction> differences = t.c;
  for (std::size_t i = 0; i < t.stages(); ++i)
    for (const Fraction& a : t.a[i]) differences[i] -= a;
  return same_weights(source, differences);
}

}  // namespace

int embedded_order(const SeriesSource& source, int highest) {
  return with_coefficients(source, [&]<class K>() {
    const ButcherTableau<K> tableau = source.tableau<K>();
    for (int n = 1; n <= highest; ++n) {
      const TreeTable table(Signature::first_order_with_time(), n);
      const TreeSeries<K> map = ElementaryWeights<K>(tableau, table).result(tableau.embedded),
                          exact = exact_flow<K>(table);
      for (TreeId t = table.begin(n); t < table.end(n); ++t)
        if (!source.zero(Fraction(map[t] - exact[t]))) return n - 1;
    }
    return highest;
  });
}

Structure structure(const SeriesSource& source) {
  Structure s;
  const SplittingSymmetry parts = splitting_symmetry(source.program(), source.values());
  s.symmetric = symmetric(source, parts);
  s.symplectic = symplectic(source, parts);
  for (const int order : std::span(kOthers).first(3)) {
    s.energy_preserving = energy_preserving(source, order);
    if (!s.energy_preserving.holds()) break;
  }
  if (!s.symplectic.holds())
    for (const int order : std::span(kOthers).first(3)) {
      s.conjugate_symplectic = conjugate_symplectic(source, order);
      if (!s.conjugate_symplectic->holds()) break;
    }
  if (source.has_tableau()) {
    const ButcherTableau<Fraction> t = source.tableau<Fraction>();
    s.stage_order = stage_order(source, t);
    s.row_sums = has_row_sums(source, t);
    if (!t.embedded.empty()) s.embedded_order = embedded_order(source, 10);
  }
  return s;
}

}  // namespace shortfall
