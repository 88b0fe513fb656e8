// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/power_growth.hpp"

#include <algorithm>

#include "analysis/algebra/sturm.hpp"
#include "analysis/stability/square_matrix.hpp"

namespace shortfall {

namespace {

/// Whether every root lies strictly inside the unit circle.
///
/// source  Cohn (1922), Ueber die Anzahl der Wurzeln einer algebraischen Gleichung in einem Kreise
template <class F>
bool inside_unit_circle(Univariate<F> p) {
  while (p.degree() > 0) {
    const F first = p[0], last = p.leading();
    if (!(first.abs() < last.abs())) return false;
    std::vector<F> next;
    for (int k = 1; k <= p.degree(); ++k) next.push_back(p[k] * last - p[p.degree() - k] * first);
    p = Univariate<F>(std::move(next));
    p = p.monic();
  }
  return true;
}

/// z^q g(z + 1/z) = p(z), for a p that equals its own reversal, of even degree 2 q.
template <class F>
Univariate<F> in_sum_with_inverse(const Univariate<F>& p) {
  const int q = p.degree() / 2;
  // z^k + z^-k as polynomials in z + 1/z: c_k = u c_{k-1} - c_{k-2}.
  const Univariate<F> u({F(0), F(1)});
  Univariate<F> before({F(2)}), now = u;
  Univariate<F> result({p[q]});
  for (int k = 1; k <= q; ++k) {
    result = result + Univariate<F>({p[q + k]}) * now;
    before = std::exchange(now, u * now - before);
  }
  return result;
}

/// Takes z - value out of p if it is a factor.
template <class F>
bool take_root(Univariate<F>& p, const F& value) {
  if (!p.at(value).is_zero()) return false;
  p = divided(p, Univariate<F>({-value, F(1)})).first;
  return true;
}

template <class F>
struct Part {
  CircleEigenvalues eigenvalues;
  Univariate<F> factor;
};

template <class F>
std::optional<Rational> as_rational(const F& value) {
  if constexpr (requires { value.is_rational(); })
    return value.is_rational() ? std::optional(value.rational()) : std::nullopt;
  else
    return value;
}

/// The eigenvalues on the circle among the roots of a square-free p; false when some root lies outside.
template <class F>
bool circle_parts(const Univariate<F>& p, int multiplicity, std::vector<Part<F>>& parts,
                  Univariate<F>& inside) {
  using Kind = CircleEigenvalues::Kind;
  Univariate<F> shared = gcd(p, p.reversed());
  inside = divided(p, shared).first;
  if (!inside_unit_circle(inside)) return false;
  for (const auto& [kind, value] : {std::pair{Kind::plus_one, F(1)}, {Kind::minus_one, F(-1)}})
    if (take_root(shared, value))
      parts.push_back({{kind, 1, multiplicity, 1, {}}, Univariate<F>({-value, F(1)})});
  if (shared.degree() < 1) return true;
  const Univariate<F> sums = in_sum_with_inverse(shared);
  if (Sturm<F>(sums).roots_between(F(-2), F(2)) != sums.degree()) return false;
  Part<F> pairs{{Kind::pairs, shared.degree(), multiplicity, 1, {}}, shared};
  if (sums.degree() == 1) {
    pairs.eigenvalues.cosine = as_rational(-sums[0] / sums[1]);
    if (pairs.eigenvalues.cosine) *pairs.eigenvalues.cosine /= 2;
  }
  parts.push_back(std::move(pairs));
  return true;
}

}  // namespace

template <class F>
PowerGrowth power_growth(const std::vector<std::vector<F>>& matrix) {
  PowerGrowth growth;
  Univariate<F> p(characteristic_coefficients(matrix));
  int zeros = 0;
  while (p.degree() > 0 && p[zeros].is_zero()) ++zeros;
  p = Univariate<F>({p.coefficients().begin() + zeros, p.coefficients().end()});
  std::vector<Part<F>> parts;
  // The factors that do not lie on the circle, with their multiplicities.
  Univariate<F> others({F(1)});
  for (int k = 0; k < zeros; ++k) others = others * Univariate<F>({F(0), F(1)});
  for (const auto& [factor, multiplicity] : squarefree_parts(p)) {
    Univariate<F> inside;
    if (!circle_parts(factor, multiplicity, parts, inside)) {
      growth.kind = PowerGrowth::Kind::exponential;
      return growth;
    }
    for (int k = 0; k < multiplicity; ++k) others = others * inside;
    growth.inside += multiplicity * inside.degree();
  }
  for (Part<F>& part : parts) {
    if (part.eigenvalues.multiplicity > 1) {
      Univariate<F> rest = others;
      for (const Part<F>& other : parts)
        for (int k = 0; &other != &part && k < other.eigenvalues.multiplicity; ++k)
          rest = rest * other.factor;
      auto left = evaluated(rest, matrix);
      const auto step = evaluated(part.factor, matrix);
      int block = 0;
      for (; !is_zero(left); ++block) left = product(left, step);
      part.eigenvalues.largest_block = block;
      growth.degree = std::max(growth.degree, block - 1);
    }
    growth.circle.push_back(part.eigenvalues);
  }
  growth.decays = parts.empty();
  if (growth.degree > 0) growth.kind = PowerGrowth::Kind::polynomial;
  return growth;
}

template PowerGrowth power_growth(const std::vector<std::vector<Rational>>&);
template PowerGrowth power_growth(const std::vector<std::vector<Algebraic>>&);
template PowerGrowth power_growth(const std::vector<std::vector<AlgebraicOver>>&);

}  // namespace shortfall
