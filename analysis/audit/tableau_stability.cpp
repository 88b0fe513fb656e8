// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/tableau_stability.hpp"

#include <algorithm>

#include "analysis/motion/agreement.hpp"
#include "analysis/stability/stability_function.hpp"

namespace shortfall {

namespace {

using Polynomial1 = Univariate<Rational>;

constexpr int kLostInProducts = 3;  // digits that products of the printed decimals may lose

/// Without the coefficients that are nothing to the digits printed.
Polynomial1 cleaned(const Polynomial1& p, const Rational& nothing) {
  std::vector<Rational> result;
  for (int k = 0; k <= p.degree(); ++k) result.push_back(p[k].abs() < nothing ? Rational() : p[k]);
  return Polynomial1(std::move(result));
}

Polynomial1 rational(const Univariate<Algebraic>& p) {
  std::vector<Rational> result;
  for (int k = 0; k <= p.degree(); ++k) result.push_back(p[k].rational());
  return Polynomial1(std::move(result));
}

/// |p(iy)|^2 in y^2.
Polynomial1 squared_size(const Polynomial1& p) {
  std::vector<Rational> even, odd;
  for (int k = 0; k <= p.degree(); ++k) (k % 2 == 0 ? even : odd).push_back(k / 2 % 2 == 0 ? p[k] : -p[k]);
  const Polynomial1 e(even), o(odd);
  return e * e + Polynomial1({Rational(0), Rational(1)}) * o * o;
}

/// A y > 0 with p(y^2) < 0.
std::optional<Rational> negative_at(const Polynomial1& p) {
  std::vector<Rational> samples;
  Rational last;
  for (const RealRoot& root : real_roots(p)) {
    if (root.compare(Rational(0)) <= 0) continue;
    const RealRoot fine = root.refined(Rational(1, 1'000'000));
    samples.push_back((last + fine.low()) / Rational(2));
    last = fine.high();
  }
  samples.push_back(last + Rational(1));
  for (const Rational& s : samples)
    if (s.sign() > 0 && p.at(s).sign() < 0) return s;
  return std::nullopt;
}

TableauStability by_digits(const StabilityFunction& r, int digits) {
  const Rational nothing = Rational(1) / Rational(10).pow(std::max(digits - kLostInProducts, 1));
  const Polynomial1 p = cleaned(rational(r.numerator), nothing),
                    q = cleaned(rational(r.denominator), nothing);
  TableauStability result;
  result.digits = digits;
  std::vector<Algebraic> mirrored;  // Q(-z)
  for (int k = 0; k <= q.degree(); ++k) mirrored.emplace_back(k % 2 == 0 ? q[k] : -q[k]);
  if (!is_hurwitz(Univariate<Algebraic>(mirrored))) {
    result.why = "R(z) has a pole with Re z <= 0";
    return result;
  }
  const auto at = negative_at(cleaned(squared_size(q) - squared_size(p), nothing));
  result.a_stable = !at;
  if (at) result.why = "|R(iy)| > 1 at y^2 = " + at->significant(4);
  result.l_stable = result.a_stable && p.degree() < q.degree();
  if (result.a_stable && !result.l_stable) result.why = "R(z) does not go to 0 at infinity";
  return result;
}

}  // namespace

std::optional<TableauStability> tableau_stability(const AuditedTableau& t) {
  if (t.nystroem || !t.program.tableau) return std::nullopt;
  const auto r = stability_function(t.program);
  if (!r) return std::nullopt;
  if (t.numbers == AuditedTableau::Numbers::digits) return by_digits(*r, printed_digits(t.program));
  const StabilityProperties s = stability_properties(*r);
  TableauStability result{s.a_stable, s.l_stable, "", 0};
  if (!s.poles_right)
    result.why = "R(z) has a pole with Re z <= 0";
  else if (!s.imaginary_axis)
    result.why = "|R(iy)| > 1 at y = " + s.violated_at->str();
  else if (!s.l_stable)
    result.why = "R(z) does not go to 0 at infinity";
  return result;
}

}  // namespace shortfall
