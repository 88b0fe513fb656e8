// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/radicals.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/algebra/gmp.hpp"
#include "analysis/algebra/surd.hpp"
#include "analysis/motion/formula_text.hpp"

namespace shortfall {

namespace {

/// r = outside^m * inside with a whole inside that has no small factor to the m-th power.
struct SplitRoot {
  Rational outside;
  Rational inside;
};

SplitRoot split_root(const Rational& r, unsigned long m) {
  mpz_class rest, outside = 1, inside = 1;
  mpz_pow_ui(rest.get_mpz_t(), gmp_denominator(r).get_mpz_t(), m - 1);
  rest *= gmp_numerator(r);
  for (unsigned long prime = 2; prime < 10'000 && rest > 1; ++prime) {
    unsigned long times = 0;
    for (; mpz_divisible_ui_p(rest.get_mpz_t(), prime); ++times) rest /= prime;
    for (; times >= m; times -= m) outside *= prime;
    for (; times > 0; --times) inside *= prime;
  }
  mpz_class root;
  if (mpz_root(root.get_mpz_t(), rest.get_mpz_t(), m))
    outside *= root;
  else
    inside *= rest;
  return {rational(outside) / r.denominator(), rational(inside)};
}

/// p + q sqrt(d), over one fraction line.
Expr surd_formula(const Surd& s) {
  if (s.is_rational()) return number(s.rational_part());
  const SplitRoot root = split_root(s.radicand(), 2);
  const Rational q = s.root_part() * root.outside;
  const Rational& p = s.rational_part();
  const Rational common = q.denominator() * (p * q.denominator()).denominator();
  const auto term = [](const Rational& size, const Expr& e) { return number(size) * e; };
  const Expr radical = term((q * common).abs(), call("sqrt", {number(root.inside)}));
  if (p.is_zero()) return (q.sign() < 0 ? negate(radical) : radical) / number(common);
  // A positive term first.
  Expr sum = q.sign() > 0 && p.sign() < 0 ? radical - number(-p * common)
             : q.sign() > 0               ? number(p * common) + radical
                                          : number(p * common) - radical;
  return sum / number(common);
}

/// sqrt(s) as a sum of two simpler roots, if it is one: sqrt(5 + 2 sqrt(6)) = sqrt(2) + sqrt(3).
std::optional<Expr> denested_root(const Surd& s) {
  const Rational square =
      s.rational_part() * s.rational_part() - s.root_part() * s.root_part() * s.radicand();
  if (square.sign() < 0) return std::nullopt;
  const Surd norm = Surd::sqrt(square);
  if (!norm.is_rational()) return std::nullopt;
  const Rational larger = (s.rational_part() + norm.rational_part()) / 2,
                 smaller = (s.rational_part() - norm.rational_part()) / 2;
  if (smaller.sign() < 0) return std::nullopt;
  const Expr a = square_root_formula(larger), b = square_root_formula(smaller);
  return s.root_part().sign() > 0 ? a + b : a - b;
}

/// coefficient * radical
struct Scaled {
  Rational coefficient;
  Expr radical;
};

/// s^(1/m), for s > 0; m-th powers come out of the root.
Scaled root_of(const Surd& s, unsigned long m) {
  Rational content = s.rational_part().abs();
  const SplitRoot inner = s.is_rational() ? SplitRoot{0, 0} : split_root(s.radicand(), 2);
  for (Rational b = (s.root_part() * inner.outside).abs(); !b.is_zero();)
    content = std::exchange(b, content - b * (content / b).floor());
  const SplitRoot outer = split_root(content, m);
  const Rational power = outer.outside.pow(static_cast<int>(m));
  const Surd rest(s.rational_part() / power, s.root_part() / power, s.radicand());
  if (rest == Surd(1)) return {outer.outside, number(1)};
  const Expr inside = surd_formula(rest);
  return {outer.outside,
          m == 2 ? call("sqrt", {inside})
                 : binary(Expression::Op::power, inside, number(Rational(1, static_cast<std::int64_t>(m))))};
}

/// The sum of all these over one fraction line, positive terms first.
Expr gathered(std::vector<Scaled> terms) {
  std::ranges::stable_sort(
      terms, [](const Scaled& a, const Scaled& b) { return a.coefficient.sign() > b.coefficient.sign(); });
  Rational common = 1;
  for (const Scaled& t : terms) common *= (common * t.coefficient).denominator();
  Expr sum = number(0);
  for (const Scaled& t : terms) {
    const Expr term = chained(number((t.coefficient * common).abs()), t.radical);
    sum = t.coefficient.sign() < 0 ? sum - term : sum + term;
  }
  return sum / number(common);
}

/// Which of the two roots of a quadratic polynomial it is.
Surd quadratic(const RealRoot& x) {
  const Rational &a = x.polynomial()[2], &b = x.polynomial()[1], &c = x.polynomial()[0];
  const Surd plus(-b / (a * 2), Rational(1) / (a * 2), b * b - a * c * 4);
  return plus > Surd(x.high()) || plus < Surd(x.low())
             ? Surd(-b / (a * 2), Rational(-1) / (a * 2), b * b - a * c * 4)
             : plus;
}

/// The only real root of a cubic polynomial.
///
/// source  Cardano (1545), Ars magna
std::optional<Expr> cubic(const Univariate<Rational>& p) {
  const Rational &a = p[3], &b = p[2], &c = p[1], &d = p[0];
  const Rational d0 = b * b - a * c * 3;
  const Rational d1 = b * b * b * 2 - a * b * c * 9 + a * a * d * 27;
  const Rational square = d1 * d1 - d0 * d0 * d0 * 4;
  if (square.sign() < 0) return std::nullopt;
  std::vector<Scaled> terms{{-b / (a * 3), number(1)}};
  for (const int sign : {1, -1}) {
    const Surd cube(d1 / 2, Rational(sign, 2), square);
    if (cube.is_zero()) continue;
    const Scaled root = root_of(cube.abs(), 3);
    terms.push_back({root.coefficient * Rational(-cube.sign()) / (a * 3), root.radical});
  }
  std::erase_if(terms, [](const Scaled& t) { return t.coefficient.is_zero(); });
  return gathered(std::move(terms));
}

/// The largest m for which p is a polynomial in x^m.
int stride(const Univariate<Rational>& p) {
  int m = 0;
  for (int k = 1; k <= p.degree(); ++k)
    if (!p[k].is_zero()) m = std::gcd(m, k);
  return m;
}

}  // namespace

Expr square_root_formula(const Rational& r) {
  if (r.is_zero()) return number(0);
  const SplitRoot root = split_root(r, 2);
  if (root.inside.is_one()) return number(root.outside);
  return number(root.outside.numerator()) * call("sqrt", {number(root.inside)}) /
         number(root.outside.denominator());
}

std::optional<Expr> radical_formula(const RealRoot& x) {
  const Univariate<Rational>& p = x.polynomial();
  const int m = x.compare(0) > 0 ? stride(p) : 1;
  const int degree = p.degree() / m;
  if (degree > 3 || (degree == 3 && m > 2)) return std::nullopt;
  std::vector<Rational> inner;
  for (int k = 0; k <= degree; ++k) inner.push_back(p[k * m]);
  const Univariate<Rational> q(inner);
  const auto root = [m](const Surd& s) { return gathered({root_of(s, static_cast<unsigned long>(m))}); };
  if (degree == 1) {
    const Rational value = -q[0] / q[1];
    return m == 1 ? number(value) : root(value);
  }
  const auto power_of = [m](const Rational& r) { return r.sign() < 0 ? -(r.abs().pow(m)) : r.pow(m); };
  if (degree == 2) {
    const Surd value = quadratic(RealRoot(q, power_of(x.low()), power_of(x.high())));
    if (m == 1) return surd_formula(value);
    if (m != 2) return root(value);
    if (auto sum = denested_root(value)) return sum;
    return root(value);
  }
  const auto value = cubic(q);
  return m == 1 || !value ? value : call("sqrt", {*value});
}

Expr polynomial_formula(const Univariate<Rational>& p, const std::string& unknown) {
  Expr total = number(0);
  for (int k = p.degree(); k >= 0; --k) {
    if (p[k].is_zero()) continue;
    const Expr term = number(p[k].abs()) * power(name(unknown), k);
    total = p[k].sign() < 0 ? total - term : total + term;
  }
  return total;
}

}  // namespace shortfall
