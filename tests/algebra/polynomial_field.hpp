// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vector fields with polynomial components, their brackets and flows by plain calculus: what Lie elements
// mean, without any word or basis.

#include <map>
#include <utility>
#include <vector>

#include "analysis/algebra/lie_element.hpp"
#include "analysis/algebra/polynomial.hpp"

namespace shortfall::test {

inline constexpr Letter kStepLetter = 15;

/// x_i' = rates[i], letters 0, 1, ... for the x_i.
using Field = std::vector<Polynomial>;

inline Polynomial derivative_along(const Field& x, const Polynomial& f) {
  Polynomial result;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (!x[j].is_zero()) result += x[j] * f.derivative(static_cast<Letter>(j));
  return result;
}

/// The commutator of the two derivatives.
inline Field commutator(const Field& x, const Field& y) {
  Field result;
  for (std::size_t i = 0; i < x.size(); ++i)
    result.push_back(derivative_along(x, y[i]) - derivative_along(y, x[i]));
  return result;
}

inline bool is_zero(const Field& x) {
  for (const Polynomial& p : x)
    if (!p.is_zero()) return false;
  return true;
}

/// Standard brackets of Lyndon words, in given fields for A and B.
class Brackets {
 public:
  Brackets(Field a, Field b, int degree) : basis_(LyndonBasis::up_to(degree)) {
    known_[{1, 0}] = std::move(a);
    known_[{1, 1}] = std::move(b);
  }
  const Field& operator()(int degree, int index) {
    const auto found = known_.find({degree, index});
    if (found != known_.end()) return found->second;
    const auto [left, right] = basis_.factors(degree, index);
    const Field u = (*this)(left.first, left.second), v = (*this)(right.first, right.second);
    return known_[{degree, index}] = commutator(u, v);
  }
  /// The part of one degree.
  Field value(const LieElement<Rational>& x, int degree) {
    Field result(known_.at({1, 0}).size());
    for (std::size_t k = 0; k < x.part(degree).size(); ++k) {
      const Rational& c = x.part(degree)[k];
      if (c.is_zero()) continue;
      const Field& p = (*this)(degree, static_cast<int>(k));
      for (std::size_t i = 0; i < p.size(); ++i) result[i] += p[i] * Polynomial(c);
    }
    return result;
  }

 private:
  const LyndonBasis& basis_;
  std::map<std::pair<int, int>, Field> known_;
};

/// Without powers of h above a highest one.
inline Polynomial truncated(const Polynomial& p, int highest) {
  std::vector<Polynomial::Term> kept;
  for (const auto& term : p.terms())
    if (term.monomial.exponent(kStepLetter) <= highest) kept.push_back(term);
  return Polynomial::from_terms(std::move(kept));
}

/// exp(sum of h^d X_d), applied to each coordinate, to a power of h.
inline std::vector<Polynomial> flow(const std::vector<Field>& by_degree, int highest) {
  const std::size_t n = by_degree[1].size();
  Field rates(n);
  for (std::size_t d = 1; d < by_degree.size(); ++d)
    for (std::size_t i = 0; i < n; ++i)
      rates[i] += by_degree[d][i] * Polynomial::letter(kStepLetter, static_cast<int>(d));
  std::vector<Polynomial> result;
  for (std::size_t i = 0; i < n; ++i) {
    Polynomial term = Polynomial::letter(static_cast<Letter>(i));
    Polynomial sum = term;
    for (int k = 1; k <= highest; ++k) {
      term = truncated(derivative_along(rates, term), highest);
      term *= Rational(1, k);
      sum += term;
    }
    result.push_back(std::move(sum));
  }
  return result;
}

/// A polynomial at other polynomials, to a power of h.
inline Polynomial composed(const Polynomial& p, const std::vector<Polynomial>& at, int highest) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : p.terms()) {
    Polynomial product(coefficient);
    for (std::size_t i = 0; i < at.size(); ++i)
      for (int k = 0; k < monomial.exponent(static_cast<Letter>(i)); ++k)
        product = truncated(product * at[i], highest);
    result += product;
  }
  return result;
}

/// The state moved along a field whose own rates it does not change (a drift or a kick) for weight * h.
inline void move(std::vector<Polynomial>& state, const Field& field, const Rational& weight, int highest) {
  const std::vector<Polynomial> before = state;
  const Polynomial time = Polynomial::letter(kStepLetter) * Polynomial(weight);
  for (std::size_t i = 0; i < state.size(); ++i)
    if (!field[i].is_zero()) state[i] += truncated(time * composed(field[i], before, highest), highest);
}

}  // namespace shortfall::test
