// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/audit/known_number.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/algebra/integer_relation.hpp"
#include "analysis/algebra/real_roots.hpp"

namespace shortfall {

namespace {

constexpr double kSurplus = 3;  // chance has to be a thousand times too weak
constexpr int kHighestDegree = 4;

double size(const Rational& r) { return std::log10(std::max(r.abs().to_double(), 1.0)); }

/// n = s^2 m with m free of squares of primes below 1000.
std::pair<Rational, Rational> square_part(Rational n) {
  Rational s(1);
  for (int p = 2; p < 1000; ++p)
    while ((n / Rational(p * p)).is_integer()) {
      n /= Rational(p * p);
      s *= Rational(p);
    }
  return {s, n};
}

/// The root of c0 + c1 x + c2 x^2 near x: (u + w sqrt(m))/d in lowest terms.
std::string quadratic_text(const std::vector<Rational>& c, const Rational& x) {
  const auto [s, m] = square_part(c[1] * c[1] - Rational(4) * c[0] * c[2]);
  Rational u = -c[1], w = s, d = Rational(2) * c[2];
  // Which of the two: the sign of (x d - u).
  if (((x * d - u).sign() < 0)) w = -w;
  if (d.sign() < 0) u = -u, w = -w, d = -d;
  for (int p = 2; p < 1000; ++p)
    while ((u / Rational(p)).is_integer() && (w / Rational(p)).is_integer() &&
           (d / Rational(p)).is_integer()) {
      u /= Rational(p);
      w /= Rational(p);
      d /= Rational(p);
    }
  std::string root = "sqrt(" + m.str() + ")";
  if (!w.abs().is_one()) root = w.abs().str() + "*" + root;
  std::string above;
  if (u.is_zero())
    above = (w.sign() < 0 ? "-" : "") + root;
  else if (w.sign() > 0 && u.sign() < 0)
    above = root + " - " + (-u).str();
  else
    above = u.str() + (w.sign() < 0 ? " - " : " + ") + root;
  if (d.is_one()) return above;
  return (u.is_zero() ? above : "(" + above + ")") + "/" + d.str();
}

std::string polynomial_text(const std::vector<Rational>& c) {
  std::string text;
  for (std::size_t k = c.size(); k-- > 0;) {
    if (c[k].is_zero()) continue;
    const bool minus = c[k].sign() < 0;
    text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
    const std::string power = k == 0 ? "" : k == 1 ? "x" : "x^" + std::to_string(k);
    const std::string number = c[k].abs().str();
    text += power.empty() ? number : c[k].abs().is_one() ? power : number + " " + power;
  }
  return text;
}

/// Whether an irreducible factor of that degree has its root where the decimal is.
bool is_root(const std::vector<Rational>& c, const Rational& decimal, const Rational& unit) {
  for (const RealRoot& root : real_roots(Univariate<Rational>(c)))
    if (root.compare(decimal - unit) >= 0 && root.compare(decimal + unit) <= 0)
      return root.degree() == static_cast<int>(c.size()) - 1;
  return false;
}

}  // namespace

std::optional<KnownNumber> known_number(const Rational& decimal, int digits, int candidates) {
  const Rational unit = Rational(1) / Rational(10).pow(digits);
  const double known = digits - std::log10(std::max(candidates, 1)) - std::log10(2);
  const Rational simple = simplest_between(decimal - unit, decimal + unit);
  if (const double surplus = known - 2 * size(simple.denominator()); surplus >= kSurplus)
    return KnownNumber{simple.str(), 1, surplus};
  for (int degree = 2; degree <= kHighestDegree; ++degree) {
    std::vector<Rational> c = small_polynomial(decimal, degree, digits);
    if (c.back().is_zero()) continue;
    if (c.back().sign() < 0)
      for (Rational& k : c) k = -k;
    double height = 0;
    for (const Rational& k : c) height = std::max(height, size(k));
    const double surplus = known - (degree + 1) * (height + std::log10(2));
    if (surplus < kSurplus || !is_root(c, decimal, unit)) continue;
    return KnownNumber{degree == 2 ? quadratic_text(c, decimal) : "a root of " + polynomial_text(c), degree,
                       surplus};
  }
  return std::nullopt;
}

}  // namespace shortfall
