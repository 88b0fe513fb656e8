// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/algebra/error.hpp"

namespace shortfall {

/// A polynomial in one unknown over a field (Rational, Algebraic), dense: for divisions and Sturm sequences.
///
/// Invariant: the leading coefficient is not 0; the zero polynomial has no coefficients.
template <class F>
class Univariate {
 public:
  Univariate() = default;
  /// Lowest first.
  Univariate(std::vector<F> coefficients) : coefficients_(std::move(coefficients)) { trim(); }

  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }  ///< -1 for zero
  bool is_zero() const { return coefficients_.empty(); }
  const F& operator[](int power) const { return coefficients_[static_cast<std::size_t>(power)]; }
  const F& leading() const { return coefficients_.back(); }
  const std::vector<F>& coefficients() const& { return coefficients_; }
  std::vector<F> coefficients() && { return std::move(coefficients_); }

  /// Its value, by Horner's rule.
  F at(const F& x) const {
    F value(0);
    for (std::size_t k = coefficients_.size(); k-- > 0;) value = value * x + coefficients_[k];
    return value;
  }
  Univariate derivative() const {
    std::vector<F> result;
    for (int k = 1; k <= degree(); ++k) result.push_back((*this)[k] * F(k));
    return result;
  }
  /// x^degree p(1/x).
  Univariate reversed() const { return std::vector<F>(coefficients_.rbegin(), coefficients_.rend()); }
  /// Divided by its leading coefficient.
  Univariate monic() const {
    if (leading() == F(1)) return *this;
    Univariate result = *this;
    for (F& c : result.coefficients_) c = c / leading();
    return result;
  }

  Univariate operator-() const {
    Univariate result = *this;
    for (F& c : result.coefficients_) c = -c;
    return result;
  }
  friend Univariate operator+(Univariate a, const Univariate& b) {
    if (a.coefficients_.size() < b.coefficients_.size()) a.coefficients_.resize(b.coefficients_.size(), F(0));
    for (std::size_t k = 0; k < b.coefficients_.size(); ++k) a.coefficients_[k] += b.coefficients_[k];
    a.trim();
    return a;
  }
  friend Univariate operator-(const Univariate& a, const Univariate& b) { return a + -b; }
  friend Univariate operator*(const Univariate& a, const Univariate& b) {
    if (a.is_zero() || b.is_zero()) return {};
    std::vector<F> result(a.coefficients_.size() + b.coefficients_.size() - 1, F(0));
    for (std::size_t i = 0; i < a.coefficients_.size(); ++i)
      for (std::size_t j = 0; j < b.coefficients_.size(); ++j)
        result[i + j] += a.coefficients_[i] * b.coefficients_[j];
    return result;
  }
  bool operator==(const Univariate&) const = default;

 private:
  void trim() {
    while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
  }
  std::vector<F> coefficients_;
};

/// Quotient and remainder of a by b.
///
/// throws  Undefined  when b is zero
template <class F>
std::pair<Univariate<F>, Univariate<F>> divided(const Univariate<F>& a, const Univariate<F>& b) {
  if (b.is_zero()) throw Undefined("division of a polynomial by zero");
  if (a.degree() < b.degree()) return {{}, a};
  std::vector<F> rest = a.coefficients();
  const int steps = a.degree() - b.degree();
  std::vector<F> quotient(static_cast<std::size_t>(steps) + 1, F(0));
  for (int k = steps; k >= 0; --k) {
    const F factor = rest[static_cast<std::size_t>(k + b.degree())] / b.leading();
    quotient[static_cast<std::size_t>(k)] = factor;
    if (factor.is_zero()) continue;
    for (int j = 0; j <= b.degree(); ++j) rest[static_cast<std::size_t>(k + j)] -= factor * b[j];
  }
  rest.resize(static_cast<std::size_t>(b.degree()), F(0));
  return {quotient, rest};
}

/// The monic greatest common divisor; zero only for two zeros.
template <class F>
Univariate<F> gcd(Univariate<F> a, Univariate<F> b) {
  while (!b.is_zero()) {
    b = b.monic();
    Univariate<F> rest = divided(a, b).second;
    a = std::move(b);
    b = std::move(rest);
  }
  return a.is_zero() ? a : a.monic();
}

/// The square-free polynomials p_i, i >= 1, with p = constant * product of p_i^i; only those that are not 1.
///
/// source  Yun (1976), On square-free decomposition algorithms
template <class F>
std::vector<std::pair<Univariate<F>, int>> squarefree_parts(const Univariate<F>& p) {
  std::vector<std::pair<Univariate<F>, int>> parts;
  if (p.degree() < 1) return parts;
  const Univariate<F> slope = p.derivative();
  const Univariate<F> common = gcd(p, slope);
  Univariate<F> left = divided(p, common).first;
  Univariate<F> right = divided(slope, common).first - left.derivative();
  for (int i = 1; left.degree() > 0; ++i) {
    const Univariate<F> part = gcd(left, right);
    if (part.degree() > 0) parts.emplace_back(part.monic(), i);
    left = divided(left, part).first;
    right = divided(right, part).first - left.derivative();
  }
  return parts;
}

}  // namespace shortfall
